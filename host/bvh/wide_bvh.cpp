#include "bvh/wide_bvh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <span>
#include <string>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "bvh/primitive_reference.hpp"

namespace lavaray {
namespace {

constexpr int kWidth = static_cast<int>(gpu::kNodeWidth);
constexpr int kMaxBound = 255;
constexpr int kExponentBias = 127;
constexpr int kMinExponent = -126;
// Nodes below this many others are widened subtree by subtree: up to 4^5 of them, enough for many threads.
constexpr std::uint32_t kTopDepth = 5;

// 2^exponent, which is a normal number.
float powerOfTwo(int exponent) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(exponent + kExponentBias) << 23U);
}

// Of a finite x > 0: floor(log2(x)), or kMinExponent - 1 if x is denormal.
int exponentOf(float x) {
  return static_cast<int>(std::bit_cast<std::uint32_t>(x) >> 23U) - kExponentBias;
}

// Quantised coordinates on one axis: bound b lies at origin + b unit, which is exact. Finding b takes a
// difference that is rounded, so that it may be one too many; but never too few, since rounding keeps the
// order. Conversions to integers round towards 0, which is down here.
struct Grid {
  float origin;
  float unit;  // 2^exponent
  int exponent;

  // In double precision, where a denormal number divided by the unit does not vanish.
  Grid(float lower, int unitExponent) : origin(0.0F), unit(powerOfTwo(unitExponent)), exponent(unitExponent) {
    const double units = double{lower} / double{unit};
    const auto whole = static_cast<double>(static_cast<std::int64_t>(units));
    origin = static_cast<float>((whole > units ? whole - 1.0 : whole) * double{unit});
  }

  // The last bounds that are not above x, and the first that are not below; x is not below the origin.
  [[nodiscard]] Int4 boundsBelow(Float4 x) const {
    const Int4 bounds = __builtin_convertvector(units(x), Int4);
    return bounds + (positions(bounds) > x);  // true is -1
  }
  [[nodiscard]] Int4 boundsAbove(Float4 x) const {
    const Float4 exact = units(x);
    const Int4 whole = __builtin_convertvector(exact, Int4);
    const Int4 bounds = whole - (__builtin_convertvector(whole, Float4) < exact);
    return bounds - (positions(bounds) < x);
  }

 private:
  [[nodiscard]] Float4 units(Float4 x) const { return (x - origin) * powerOfTwo(-exponent); }
  [[nodiscard]] Float4 positions(Int4 bounds) const {
    return origin + __builtin_convertvector(bounds, Float4) * unit;
  }
};

// The finest grid that has lower and upper between bounds 0 and 255 and whose every bound is exact in
// float32: the origin is a multiple of 2^exponent, and no bound is more than 2^24 such units from 0.
Grid gridFor(float lower, float upper) {
  const float magnitude = std::max(std::abs(lower), std::abs(upper));
  const float step = (upper - lower) / static_cast<float>(kMaxBound);
  int exponent = kMinExponent;
  if (step > 0.0F) exponent = std::max(exponent, exponentOf(step));
  if (magnitude > 0.0F) exponent = std::max(exponent, exponentOf(magnitude) - 22);
  for (;; ++exponent) {
    const Grid grid(lower, exponent);
    if (grid.boundsAbove(Float4{upper, upper, upper, upper})[0] <= kMaxBound) return grid;
  }
}

// One byte for each of the four, the first in the lowest.
gpu::uint pack(Int4 bounds) {
  return static_cast<gpu::uint>(bounds[0] | bounds[1] << 8 | bounds[2] << 16) |
         static_cast<gpu::uint>(bounds[3]) << 24U;
}

// Quantises the children's boxes in the grid of the node's own box, rounded outwards. A missing child has its
// bounds the wrong way round, so that no single ray enters it.
void setBoxes(gpu::BvhNode& node, const Box& own, std::span<const Box> children) {
  std::array<Box, kWidth> boxes;
  boxes.fill(own);
  std::ranges::copy(children, boxes.begin());
  const gpu::uint present = ~0U >> (8U * (gpu::kNodeWidth - static_cast<gpu::uint>(children.size())));
  node.exponents = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Grid grid = gridFor(own.lower[axis], own.upper[axis]);
    node.origin[axis] = grid.origin;
    node.exponents |= static_cast<gpu::uint>(grid.exponent + kExponentBias) << (8 * axis);
    const Float4 lower{boxes[0].lower[axis], boxes[1].lower[axis], boxes[2].lower[axis],
                       boxes[3].lower[axis]};
    const Float4 upper{boxes[0].upper[axis], boxes[1].upper[axis], boxes[2].upper[axis],
                       boxes[3].upper[axis]};
    node.lower[axis] = pack(grid.boundsBelow(lower)) | ~present;
    node.upper[axis] = pack(grid.boundsAbove(upper)) & present;
  }
}

// Nodes of the binary tree that become children of one wide node.
struct Children {
  std::array<std::uint32_t, gpu::kNodeWidth> nodes;
  std::size_t count = 0;

  void add(std::uint32_t node) { nodes[count++] = node; }
};

// A subtree that is widened apart from the nodes above it: the roots of its binary and of its wide form.
struct Subtree {
  std::uint32_t root;
  std::uint32_t wideRoot;
};

class Widener {
 public:
  explicit Widener(const Bvh& bvh) : bvh_(bvh) {}

  // The nodes down to kTopDepth. What is below is left to do: `subtrees`, whose roots have their places
  // already.
  WideBvh top(std::vector<Subtree>& subtrees) {
    subtrees_ = &subtrees;
    result_.nodes.push_back({});
    setBoxes(result_.nodes[0], bvh_.nodes[0].box, {&bvh_.nodes[0].box, 1});
    const gpu::uint root = add(0, 0);
    result_.nodes[0].children = glm::uvec4(gpu::kMissingChild);
    result_.nodes[0].children.x = root;
    return std::move(result_);
  }

  // Node 0 is the subtree's root.
  WideBvh below(const Subtree& subtree) {
    add(subtree.root, kTopDepth);
    return std::move(result_);
  }

 private:
  // Returns the node reference of the subtree, which lies below `depth` inner nodes.
  gpu::uint add(std::uint32_t index, std::uint32_t depth) {
    const BvhNode& node = bvh_.nodes[index];
    if (node.count > 0) return addLeaf(node);
    assert(depth < gpu::kMaxBvhDepth);
    result_.depth = std::max(result_.depth, depth + 1);
    const auto reference = static_cast<gpu::uint>(result_.nodes.size());
    result_.nodes.push_back({});
    if (subtrees_ != nullptr && depth == kTopDepth) {
      subtrees_->push_back({index, reference});
      return reference;
    }
    gpu::BvhNode wide{};
    wide.children = glm::uvec4(gpu::kMissingChild);
    const Children children = open(index);
    std::array<Box, gpu::kNodeWidth> boxes;
    for (std::size_t i = 0; i < children.count; ++i) boxes[i] = bvh_.nodes[children.nodes[i]].box;
    setBoxes(wide, node.box, {boxes.data(), children.count});
    for (std::size_t i = 0; i < children.count; ++i) {
      wide.children[static_cast<int>(i)] = add(children.nodes[i], depth + 1);
    }
    result_.nodes[reference] = wide;
    return reference;
  }

  gpu::uint addLeaf(const BvhNode& leaf) {
    assert(leaf.count <= gpu::kMaxLeafSize);
    const auto first = static_cast<gpu::uint>(result_.order.size());
    const auto begin = bvh_.order.begin() + leaf.first;
    result_.order.insert(result_.order.end(), begin, begin + leaf.count);
    return leaf.count << gpu::kLeafShift | first;
  }

  // The node's two children; then, while there is room, an inner one is replaced by its own two: always the
  // one with the largest surface, which a ray is most likely to visit. Largest first: the order in which a
  // shadow ray, which needs no nearest hit, visits them.
  [[nodiscard]] Children open(std::uint32_t node) const {
    Children children;
    children.add(node + 1);
    children.add(bvh_.nodes[node].first);
    const auto rank = [&](std::uint32_t i) {
      return bvh_.nodes[i].count > 0 ? -1.0F : halfArea(bvh_.nodes[i].box);
    };
    while (children.count < gpu::kNodeWidth) {
      const auto begin = children.nodes.begin();
      const auto largest = std::max_element(begin, begin + static_cast<std::ptrdiff_t>(children.count),
                                            [&](auto a, auto b) { return rank(a) < rank(b); });
      const std::uint32_t opened = *largest;
      if (bvh_.nodes[opened].count > 0) break;
      *largest = opened + 1;
      children.add(bvh_.nodes[opened].first);
    }
    sortByArea(children);
    return children;
  }

  // By insertion, which is fastest for four.
  void sortByArea(Children& children) const {
    std::array<float, gpu::kNodeWidth> areas;
    for (std::size_t i = 0; i < children.count; ++i) {
      const std::uint32_t node = children.nodes[i];
      const float area = halfArea(bvh_.nodes[node].box);
      std::size_t at = i;
      for (; at > 0 && areas[at - 1] < area; --at) {
        areas[at] = areas[at - 1];
        children.nodes[at] = children.nodes[at - 1];
      }
      areas[at] = area;
      children.nodes[at] = node;
    }
  }

  const Bvh& bvh_;
  WideBvh result_;
  std::vector<Subtree>* subtrees_ = nullptr;
};

// Where a widened subtree goes: its root to a node of its own, all others and the primitives in one row each.
struct Place {
  std::uint32_t root;
  std::uint32_t nodes;
  std::uint32_t primitives;
};

// By its box, which ends before it begins.
bool isMissing(const gpu::BvhNode& node, int child) {
  return (node.lower.x >> (8 * child) & 255U) > (node.upper.x >> (8 * child) & 255U);
}

void insert(const WideBvh& subtree, const Place& place, WideBvh& result) {
  for (std::uint32_t i = 0; i < subtree.nodes.size(); ++i) {
    gpu::BvhNode node = subtree.nodes[i];
    for (int child = 0; child < kWidth; ++child) {
      if (isMissing(node, child)) continue;
      gpu::uint& reference = node.children[child];
      reference += reference > gpu::kMaxReference ? place.primitives : place.nodes - 1;
    }
    result.nodes[i == 0 ? place.root : place.nodes + i - 1] = node;
  }
  std::ranges::copy(subtree.order, result.order.begin() + place.primitives);
}

}  // namespace

WideBvh widen(const Bvh& bvh, unsigned threads) {
  // Starting threads takes longer than widening so few.
  constexpr std::size_t kMaxForOneThread = 8192;
  if (bvh.order.size() <= kMaxForOneThread) threads = 1;
  std::vector<Subtree> subtrees;
  WideBvh result = Widener(bvh).top(subtrees);
  std::vector<WideBvh> parts(subtrees.size());
  parallelFor(parts.size(), threads, [&](std::size_t i) { parts[i] = Widener(bvh).below(subtrees[i]); });

  std::size_t nodes = result.nodes.size();
  std::size_t primitives = result.order.size();
  std::vector<Place> places;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    places.push_back(
        {subtrees[i].wideRoot, static_cast<std::uint32_t>(nodes), static_cast<std::uint32_t>(primitives)});
    nodes += parts[i].nodes.size() - 1;
    primitives += parts[i].order.size();
    result.depth = std::max(result.depth, parts[i].depth);
  }
  if (nodes - 1 > gpu::kMaxNode) {
    throw Error(ExitCode::kInput,
                "the scene has too many spheres and triangles: their hierarchy would have more than " +
                    std::to_string(gpu::kMaxNode) + " nodes");
  }
  result.nodes.resize(nodes);
  result.order.resize(primitives);
  parallelFor(parts.size(), threads, [&](std::size_t i) {
    insert(parts[i], places[i], result);
    parts[i] = {};
  });
  return result;
}

Box childBox(const gpu::BvhNode& node, int child) {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const int exponent = static_cast<int>((node.exponents >> (8 * axis)) & 255U) - kExponentBias;
    const float unit = std::ldexp(1.0F, exponent);
    box.lower[axis] = node.origin[axis] + static_cast<float>((node.lower[axis] >> (8 * child)) & 255U) * unit;
    box.upper[axis] = node.origin[axis] + static_cast<float>((node.upper[axis] >> (8 * child)) & 255U) * unit;
  }
  return box;
}

}  // namespace lavaray
