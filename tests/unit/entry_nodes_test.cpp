#include "render/entry_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <set>

#include <glm/vec3.hpp>

#include "bvh/flatten.hpp"
#include "bvh/wide_bvh.hpp"
#include "sampling/pixel_filter.hpp"
#include "support/random_numbers.hpp"

namespace lavaray {
namespace {

constexpr ImageSize kSize{150, 100};

Scene sceneOfBalls(Random& random, double nearest, double farthest) {
  Scene scene;
  scene.camera = {{1, 2, 3}, 60.0, kSize.height / (2.0 * std::tan(M_PI / 6.0)) + 1e-9, 1.5};
  scene.materials.resize(300);
  for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
    const glm::dvec3 place(uniform(random, -4.0, 4.0), uniform(random, -3.0, 3.0),
                           -uniform(random, nearest, farthest));
    scene.spheres.push_back({scene.camera.position + place, std::exp(uniform(random, -5.0, -1.0)), i});
  }
  return scene;
}

bool isHit(const Box& box, const glm::dvec3& direction) {
  double entry = 0.0;
  double exit = INFINITY;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = box.lower[axis] / direction[axis];
    const double b = box.upper[axis] / direction[axis];
    entry = std::max(entry, std::min(a, b));
    exit = std::min(exit, std::max(a, b));
  }
  return entry <= exit;
}

// Adds the references of all leaves below the child of a packed group that the ray enters.
void collectLeaves(const GpuScene& scene, gpu::uint group, const glm::dvec3& direction,
                   std::set<gpu::uint>& leaves) {
  if (group == 0) return;
  const gpu::BvhNode& node = scene.nodes[group >> gpu::kGroupNodeShift];
  const gpu::uint slot = firstSlot(group);
  const gpu::uint child = node.children[static_cast<int>(slot)];
  const Box box = childBox(node, static_cast<int>(slot));
  if (box.lower.x > box.upper.x || !isHit(box, direction)) return;
  if (child > gpu::kMaxReference) {
    leaves.insert(child);
    return;
  }
  for (gpu::uint i = 0; i < gpu::kNodeWidth; ++i) {
    collectLeaves(scene, groupOf(child, i), direction, leaves);
  }
}

struct Figures {
  int rays = 0;
  int leaves = 0;
  int belowTheRoot = 0;
  int nowhere = 0;
};

// Rays through random points of the crop's pixels, as far from a pixel as the filter's radius.
Figures compareWithTheRoot(const Scene& scene, const RenderSettings& settings, Random& random) {
  const GpuScene flat = flatten(scene, 1);
  const EntryNodes nodes = entryNodes(flat, settings, settings.crop);
  const Rectangle& crop = settings.crop;
  const double radius = filterRadius(settings.filter);
  Figures figures;
  for (; figures.rays < 20000; ++figures.rays) {
    const auto x = static_cast<int>(random() % static_cast<unsigned>(crop.width()));
    const auto y = static_cast<int>(random() % static_cast<unsigned>(crop.height()));
    const gpu::uint group = nodes.groups[std::size_t(y >> nodes.shift) * nodes.across + (x >> nodes.shift)];
    EXPECT_EQ(isEmpty(nodes, y * crop.width() + x, crop.width()), group == 0);
    const double column = crop.x0 + x + 0.5 + uniform(random, -radius, radius);
    const double row = crop.y0 + y + 0.5 + uniform(random, -radius, radius);
    const double scale = static_cast<double>(imageSize(scene.camera)->width) / settings.size.width;
    const glm::dvec3 direction((column - settings.size.width / 2.0) * scale,
                               (settings.size.height / 2.0 - row) * scale, -scene.camera.focalLength);
    std::set<gpu::uint> all;
    std::set<gpu::uint> reached;
    collectLeaves(flat, gpu::kRootGroup, direction, all);
    collectLeaves(flat, group, direction, reached);
    EXPECT_EQ(reached, all) << column << ' ' << row;
    figures.leaves += static_cast<int>(all.size());
    figures.belowTheRoot += group > gpu::kRootGroup ? 1 : 0;
    figures.nowhere += group == 0 ? 1 : 0;
  }
  return figures;
}

// Balls before the camera, around it, and behind it; whole images, crops, and images of many pixels.
TEST(EntryNodes, ReachAllThatTheTilesRaysReach) {
  Random random(4);
  RenderSettings settings;
  for (const auto& [nearest, farthest] : {std::pair{5.0, 12.0}, {-6.0, 6.0}, {-9.0, -5.0}}) {
    const Scene scene = sceneOfBalls(random, nearest, farthest);
    ASSERT_EQ(imageSize(scene.camera)->width, kSize.width);
    for (const int factor : {1, 7}) {
      settings.size = {kSize.width * factor, kSize.height * factor};
      for (const PixelFilter filter : {PixelFilter::kBox, PixelFilter::kGaussian}) {
        settings.filter = filter;
        settings.crop = {0, 0, settings.size.width, settings.size.height};
        const Figures whole = compareWithTheRoot(scene, settings, random);
        std::cout << whole.leaves << " leaves on " << whole.rays << " rays, " << whole.belowTheRoot
                  << " of which enter below the root, " << whole.nowhere << " nowhere\n";
        settings.crop = {31, 17, 90, 99};
        compareWithTheRoot(scene, settings, random);
        if (nearest > 0.0) {
          EXPECT_GT(whole.belowTheRoot, whole.rays / 5);
          EXPECT_GT(whole.nowhere, 0);
        }
        EXPECT_EQ(whole.leaves == 0, farthest < 0.0);
        EXPECT_EQ(whole.nowhere == whole.rays, farthest < 0.0);
      }
    }
  }
}

TEST(EntryNodes, AreFewWhateverTheImage) {
  Random random(4);
  const Scene scene = sceneOfBalls(random, 5.0, 12.0);
  RenderSettings settings;
  settings.size = {60000, 40000};
  settings.crop = {0, 0, 60000, 40000};
  const EntryNodes nodes = entryNodes(flatten(scene, 1), settings, settings.crop);
  EXPECT_LE(nodes.groups.size(), 1U << 18U);
  EXPECT_EQ(nodes.across, (60000U + (1U << nodes.shift) - 1) >> nodes.shift);
}

}  // namespace
}  // namespace lavaray
