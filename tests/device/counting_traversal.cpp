#include "device/counting_traversal.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "bvh/wide_bvh.hpp"

namespace lavaray {
namespace {

// Where the sides of a box may be, as seen by the shader: rounding moves them by less.
constexpr double kUnsure = 1e-4;

struct Child {
  double entry;
  int slot;
};

// Where the ray enters the box, enlarged by `growth`.
std::optional<double> entryOf(const CountedSearch& search, const Box& box, double growth) {
  double entry = 0.0;
  double exit = search.end;
  for (int axis = 0; axis < 3; ++axis) {
    const double toLower = double{box.lower[axis]} - growth - search.origin[axis];
    const double toUpper = double{box.upper[axis]} + growth - search.origin[axis];
    const double a = toLower / search.direction[axis];
    const double b = toUpper / search.direction[axis];
    entry = std::max(entry, std::min(a, b));
    exit = std::min(exit, std::max(a, b));
  }
  return entry <= exit ? std::optional(entry) : std::nullopt;
}

// Of the children that the ray enters, the nearest one first; in the order of their slots where any hit does.
std::vector<Child> enteredChildren(const gpu::BvhNode& node, CountedSearch& search) {
  std::vector<Child> children;
  double unsureEntry = 0.0;
  for (int slot = 0; slot < static_cast<int>(gpu::kNodeWidth); ++slot) {
    const Box box = childBox(node, slot);
    if (box.lower.x > box.upper.x) continue;
    const auto earliest = entryOf(search, box, kUnsure);
    const auto entry = entryOf(search, box, 0.0);
    const auto latest = entryOf(search, box, -kUnsure);
    if (earliest.has_value() != latest.has_value()) search.isClear = false;
    if (!entry) continue;
    children.push_back({*entry, slot});
    if (earliest && latest) unsureEntry = std::max(unsureEntry, *latest - *earliest);
  }
  if (search.isAny) return children;
  std::sort(children.begin(), children.end(), [](const Child& a, const Child& b) {
    return a.entry < b.entry || (a.entry == b.entry && a.slot < b.slot);
  });
  for (std::size_t i = 1; i < children.size(); ++i) {
    const double apart = children[i].entry - children[i - 1].entry;
    if (apart > 0.0 && apart <= unsureEntry) search.isClear = false;
  }
  return children;
}

void testSphere(const gpu::Primitive& sphere, std::uint32_t index, CountedSearch& search) {
  const double length = glm::length(search.direction);
  const glm::dvec3 unit = search.direction / length;
  const glm::dvec3 toCenter = glm::dvec3(sphere.a) - search.origin;
  const double radius = double{sphere.b.x};
  const double middle = glm::dot(toCenter, unit);
  const double offAxis = glm::length(toCenter - middle * unit);
  if (std::abs(offAxis - radius) < kUnsure) search.isClear = false;
  if (offAxis > radius) return;
  const double distance = middle - std::sqrt(radius * radius - offAxis * offAxis);
  for (const double end : {0.0, search.end * length}) {
    if (std::abs(distance - end) < kUnsure) search.isClear = false;
  }
  if (distance <= 0.0 || distance >= search.end * length) return;
  search.end = distance / length;
  search.hit = index;
}

// False where the search is over.
bool visit(const GpuScene& scene, gpu::uint reference, CountedSearch& search) {
  if (reference > gpu::kMaxReference) {
    const std::uint32_t first = reference & gpu::kMaxReference;
    for (std::uint32_t i = first; i < first + (reference >> gpu::kLeafShift); ++i) {
      if (i == search.skipped) continue;
      ++search.tests;
      testSphere(scene.primitives[i], i, search);
    }
    return !search.isAny || search.hit == 0xFFFFFFFF;
  }
  ++search.tests;
  const gpu::BvhNode& node = scene.nodes[reference];
  const std::vector<Child> children = enteredChildren(node, search);
  return std::all_of(children.begin(), children.end(),
                     [&](const Child& child) { return visit(scene, node.children[child.slot], search); });
}

}  // namespace

void run(const GpuScene& scene, gpu::uint start, CountedSearch& search) {
  if (start == 0) return;
  const gpu::BvhNode& above = scene.nodes[start >> gpu::kGroupNodeShift];
  visit(scene, above.children[static_cast<int>(firstSlot(start))], search);
}

}  // namespace lavaray
