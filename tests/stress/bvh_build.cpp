// The tree as built: its cost against the best greedy one, and its depth where the input works against it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bvh/bvh.hpp"
#include "bvh/primitives.hpp"
#include "interface.h"
#include "scene/scene_reader.hpp"
#include "stress/report.hpp"
#include "support/bvh_soundness.hpp"
#include "support/scene_building.hpp"

namespace lavaray {
namespace {

// The SAH cost, times the root's area, of the tree that tries every split of the boxes sorted by centroid on
// each axis: the best that a greedy top-down builder can choose.
double fullSweepCost(std::vector<Box> boxes) {
  Box all;
  for (const Box& box : boxes) all.extend(box);
  const double leafCost = double{halfArea(all)} * static_cast<double>(boxes.size());
  double bestCost = INFINITY;
  std::size_t bestCount = 0;
  int bestAxis = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::sort(boxes.begin(), boxes.end(), [axis](const Box& a, const Box& b) {
      return a.doubledCentroid()[axis] < b.doubledCentroid()[axis];
    });
    std::vector<double> rightCost(boxes.size());
    Box right;
    for (std::size_t i = boxes.size() - 1; i > 0; --i) {
      right.extend(boxes[i]);
      rightCost[i] = double{halfArea(right)} * static_cast<double>(boxes.size() - i);
    }
    Box left;
    for (std::size_t i = 1; i < boxes.size(); ++i) {
      left.extend(boxes[i - 1]);
      const double cost = double{halfArea(left)} * static_cast<double>(i) + rightCost[i];
      if (cost < bestCost) {
        bestCost = cost;
        bestCount = i;
        bestAxis = axis;
      }
    }
  }
  if (boxes.size() <= gpu::kMaxLeafSize && leafCost <= bestCost + double{halfArea(all)}) return leafCost;
  std::sort(boxes.begin(), boxes.end(), [bestAxis](const Box& a, const Box& b) {
    return a.doubledCentroid()[bestAxis] < b.doubledCentroid()[bestAxis];
  });
  const auto middle = boxes.begin() + static_cast<std::ptrdiff_t>(bestCount);
  return double{halfArea(all)} + fullSweepCost({boxes.begin(), middle}) +
         fullSweepCost({middle, boxes.end()});
}

std::vector<Box> boxesOf(const Scene& scene) {
  std::vector<Box> boxes;
  const Primitives primitives(scene);
  for (std::uint32_t i = 0; i < primitives.size(); ++i) boxes.push_back(primitives.box(i));
  return boxes;
}

Scene slivers() {
  Random random(2);
  Scene scene;
  for (int i = 0; i < 4000; ++i) {
    const glm::dvec3 a = randomPoint(random, 10.0);
    const glm::dvec3 along = randomPoint(random, 5.0);
    addTriangle(scene, a, a + along, a + 0.5 * along + randomPoint(random, 1e-4));
  }
  return scene;
}

Scene bumpySphere() {
  Random random(3);
  Scene scene;
  addGrid(scene, sphereGrid(64, 0.1, random), random);
  return scene;
}

TEST(BvhCost, IsAtMostFivePercentAboveAFullSweep) {
  const std::string scenes = LAVARAY_SCENES_DIR;
  const std::vector<std::pair<std::string, std::vector<Box>>> inputs{
      {"knot", boxesOf(readScene(scenes + "/showcase.txt"))},
      {"statue", boxesOf(readScene(scenes + "/handout.txt"))},
      {"torus", boxesOf(readScene(scenes + "/torus.txt"))},
      {"bumpy sphere", boxesOf(bumpySphere())},
      {"slivers", boxesOf(slivers())},
      {"1,000 spheres", boxesOf(readScene(scenes + "/thousand-spheres.txt"))},
      {"small boxes", randomBoxes(4000, 100.0F, 0.5F, 9)},
      {"large boxes", randomBoxes(4000, 100.0F, 50.0F, 9)}};
  for (const auto& [name, boxes] : inputs) {
    const Bvh bvh = buildBvh(boxes, 1);
    const double best = fullSweepCost(boxes) / double{halfArea(bvh.nodes[0].box)};
    const double cost = measure(bvh).sahCost;
    EXPECT_LE(cost, 1.05 * best) << name;
    report(name + ": SAH cost " + shortNumber(cost) + ", full sweep " + shortNumber(best) + ", ratio " +
           shortNumber(cost / best));
  }
}

// Down there the builder tries every split itself.
TEST(BvhCost, IsThatOfAFullSweepForFewPrimitives) {
  double worst = 1.0;
  for (std::size_t count = 1; count <= 32; ++count) {
    const std::vector<Box> boxes = randomBoxes(count, 10.0F, 3.0F, static_cast<unsigned>(count));
    const Bvh bvh = buildBvh(boxes, 1);
    const double best = fullSweepCost(boxes) / double{halfArea(bvh.nodes[0].box)};
    EXPECT_NEAR(measure(bvh).sahCost, best, 1e-5 * best) << count << " primitives";
    worst = std::max(worst, measure(bvh).sahCost / best);
  }
  report("1 to 32 boxes: ratio at most " + shortNumber(worst));
}

// The traversal's stack has an entry for each inner node of the longest path.
void expectShallow(const std::string& name, const std::vector<Box>& boxes) {
  const Bvh bvh = buildBvh(boxes, 2);
  expectSound(bvh, boxes);
  const unsigned depth = measure(bvh).depth;
  EXPECT_LE(depth, gpu::kMaxBvhDepth) << name;
  report(name + ": depth " + std::to_string(depth) + " of " + std::to_string(gpu::kMaxBvhDepth) + " for " +
         grouped(boxes.size()) + " boxes");
}

TEST(BvhDepth, FitsTheStackForAMillionDuplicates) {
  const std::vector<Box> boxes(1'000'000, Box{glm::vec3(1.0F), glm::vec3(2.0F)});
  expectShallow("duplicates", boxes);
  EXPECT_EQ(buildBvh(boxes, 2).largestCoincidentGroup, 1'000'000U);
}

TEST(BvhDepth, FitsTheStackForBoxesAboutOneCentre) {
  std::vector<Box> boxes;
  for (int i = 1; i <= 100'000; ++i) {
    boxes.push_back({glm::vec3(static_cast<float>(-i)), glm::vec3(static_cast<float>(i))});
  }
  expectShallow("one centre", boxes);
}

// Each box is a little nearer to the origin than the last, in proportion, so that every SAH split takes a few
// off the end: the worst case for the depth.
TEST(BvhDepth, FitsTheStackForAnExponentialChain) {
  for (const float ratio : {0.5F, 0.8F, 0.99F}) {
    std::vector<Box> boxes;
    float position = 1e15F;
    for (int i = 0; i < 100'000; ++i) {
      boxes.push_back({glm::vec3(position, 0.0F, 0.0F), glm::vec3(position * 1.001F, 1.0F, 1.0F)});
      position = position < 1e-30F ? 1e15F : position * ratio;
    }
    expectShallow("chain of ratio " + shortNumber(ratio), boxes);
  }
}

TEST(BvhDepth, FitsTheStackForSortedBoxes) {
  std::vector<Box> boxes;
  for (int i = 0; i < 100'000; ++i) {
    const auto x = static_cast<float>(i);
    boxes.push_back({glm::vec3(x, 0.0F, 0.0F), glm::vec3(x + 1.0F, 1.0F, 1.0F)});
  }
  expectShallow("ascending", boxes);
  std::reverse(boxes.begin(), boxes.end());
  expectShallow("descending", boxes);
}

}  // namespace
}  // namespace lavaray
