#include "core/bvh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <random>

#include "interface.h"

namespace lavaray {
namespace {

// Walks the whole tree: every primitive stands in exactly one leaf, no leaf is too large, no path too long,
// and every box holds what is below it, tightly.
void expectSound(const Bvh& bvh, std::span<const Box> boxes) {
  std::vector<int> seen(boxes.size(), 0);
  const std::function<Box(std::uint32_t, unsigned)> visit = [&](std::uint32_t index, unsigned depth) {
    const BvhNode& node = bvh.nodes.at(index);
    Box content;
    if (node.count > 0) {
      EXPECT_LE(node.count, gpu::kMaxLeafSize);
      EXPECT_LE(depth, gpu::kMaxBvhDepth);
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        ++seen.at(bvh.order.at(i));
        content.extend(boxes[bvh.order[i]]);
      }
    } else {
      content.extend(visit(node.left, depth + 1));
      content.extend(visit(node.right, depth + 1));
    }
    EXPECT_EQ(content.lower, node.box.lower);
    EXPECT_EQ(content.upper, node.box.upper);
    return node.box;
  };
  visit(0, 0);
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
  EXPECT_LE(measure(bvh).depth, gpu::kMaxBvhDepth);
}

std::vector<Box> randomBoxes(std::size_t count, float spread, float size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> position(-spread, spread);
  std::uniform_real_distribution<float> extent(0.0F, size);
  std::vector<Box> boxes(count);
  for (Box& box : boxes) {
    box.lower = {position(random), position(random), position(random)};
    box.upper = box.lower + glm::vec3(extent(random), extent(random), extent(random));
  }
  return boxes;
}

void expectSameTree(const Bvh& a, const Bvh& b) {
  ASSERT_EQ(a.order, b.order);
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    ASSERT_EQ(a.nodes[i].count, b.nodes[i].count);
    ASSERT_EQ(a.nodes[i].left, b.nodes[i].left);
    ASSERT_EQ(a.nodes[i].right, b.nodes[i].right);
    if (a.nodes[i].count + a.nodes[i].left == 0) continue;  // a gap
    ASSERT_EQ(a.nodes[i].box.lower, b.nodes[i].box.lower);
    ASSERT_EQ(a.nodes[i].box.upper, b.nodes[i].box.upper);
  }
}

TEST(Bvh, IsSoundForSmallAndLargeInput) {
  for (const std::size_t count : {1, 2, 3, 8, 9, 100, 1000, 40000}) {
    SCOPED_TRACE(count);
    const std::vector<Box> boxes = randomBoxes(count, 100.0F, 3.0F, 1);
    expectSound(buildBvh(boxes, 2), boxes);
  }
}

TEST(Bvh, IsTheSameWhateverTheThreadCount) {
  const std::vector<Box> boxes = randomBoxes(60000, 100.0F, 1.0F, 2);
  const Bvh one = buildBvh(boxes, 1);
  for (const unsigned threads : {2U, 3U, 8U}) expectSameTree(one, buildBvh(boxes, threads));
}

TEST(Bvh, SeparatesClusters) {
  std::vector<Box> boxes = randomBoxes(64, 1.0F, 0.1F, 3);
  for (std::size_t i = 0; i < 32; ++i) {
    boxes[i].lower.x += 1000.0F;
    boxes[i].upper.x += 1000.0F;
  }
  const Bvh bvh = buildBvh(boxes, 1);
  const Box& left = bvh.nodes[bvh.nodes[0].left].box;
  const Box& right = bvh.nodes[bvh.nodes[0].right].box;
  EXPECT_TRUE(left.upper.x < right.lower.x || right.upper.x < left.lower.x);
}

TEST(Bvh, HandlesAMillionDuplicates) {
  const std::vector<Box> boxes(1000000, Box{glm::vec3(1.0F), glm::vec3(2.0F)});
  const Bvh bvh = buildBvh(boxes, 2);
  expectSound(bvh, boxes);
  EXPECT_EQ(bvh.largestCoincidentGroup, 1000000U);
}

TEST(Bvh, HandlesBoxesAboutOneCentre) {
  std::vector<Box> boxes;
  for (int i = 1; i <= 1000; ++i) {
    boxes.push_back({glm::vec3(static_cast<float>(-i)), glm::vec3(static_cast<float>(i))});
  }
  expectSound(buildBvh(boxes, 2), boxes);
}

TEST(Bvh, HandlesFlatBoxesAndPoints) {
  std::vector<Box> flat = randomBoxes(5000, 10.0F, 1.0F, 4);
  for (Box& box : flat) box.lower.y = box.upper.y = 0.0F;
  expectSound(buildBvh(flat, 2), flat);
  std::vector<Box> points = randomBoxes(5000, 10.0F, 0.0F, 5);
  expectSound(buildBvh(points, 2), points);
}

TEST(Bvh, HandlesFarAndHugeAndTinyCoordinates) {
  std::vector<Box> far = randomBoxes(5000, 1.0F, 0.01F, 6);
  for (Box& box : far) {
    box.lower += glm::vec3(148376.0F, 1234.0F, -223423.0F);
    box.upper += glm::vec3(148376.0F, 1234.0F, -223423.0F);
  }
  expectSound(buildBvh(far, 2), far);
  const std::vector<Box> huge = randomBoxes(5000, 1e15F, 1e14F, 7);
  expectSound(buildBvh(huge, 2), huge);
  const std::vector<Box> tiny = randomBoxes(5000, 1e-38F, 1e-39F, 8);
  expectSound(buildBvh(tiny, 2), tiny);
}

// Each box is half as far out as the last, so that every SAH split takes a few off the end: the worst case
// for the depth.
TEST(Bvh, BoundsTheDepthOfAnExponentialChain) {
  std::vector<Box> boxes;
  float position = 1e15F;
  for (int i = 0; i < 100000; ++i) {
    boxes.push_back({glm::vec3(position, 0.0F, 0.0F), glm::vec3(position * 1.001F, 1.0F, 1.0F)});
    position = i % 700 == 699 ? 1e15F : position * 0.8F;
  }
  expectSound(buildBvh(boxes, 2), boxes);
}

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

TEST(Bvh, CostsAtMostFivePercentMoreThanAFullSweep) {
  for (const float size : {0.5F, 5.0F, 50.0F}) {
    const std::vector<Box> boxes = randomBoxes(4000, 100.0F, size, 9);
    const Bvh bvh = buildBvh(boxes, 1);
    const double best = fullSweepCost(boxes) / double{halfArea(bvh.nodes[0].box)};
    const double cost = measure(bvh).sahCost;
    EXPECT_LE(cost, 1.05 * best) << "boxes of up to " << size;
    std::cout << "SAH cost " << cost << ", full sweep " << best << '\n';
  }
}

}  // namespace
}  // namespace lavaray
