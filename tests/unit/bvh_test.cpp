#include "bvh/bvh.hpp"

#include <gtest/gtest.h>

#include "support/bvh_soundness.hpp"

namespace lavaray {
namespace {

void expectSameTree(const Bvh& a, const Bvh& b) {
  ASSERT_EQ(a.order, b.order);
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  std::vector<std::uint32_t> toVisit{0};
  while (!toVisit.empty()) {
    const std::uint32_t index = toVisit.back();
    const BvhNode& nodeA = a.nodes.at(index);
    const BvhNode& nodeB = b.nodes.at(index);
    toVisit.pop_back();
    ASSERT_EQ(nodeA.box.lower, nodeB.box.lower);
    ASSERT_EQ(nodeA.box.upper, nodeB.box.upper);
    ASSERT_EQ(nodeA.count, nodeB.count);
    ASSERT_EQ(nodeA.first, nodeB.first);
    if (nodeA.count == 0) toVisit.insert(toVisit.end(), {index + 1, nodeA.first});
  }
}

TEST(Bvh, IsSoundForSmallAndLargeInput) {
  for (const std::size_t count : {1, 2, 3, 8, 9, 32, 33, 100, 1000, 40000}) {
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
  const Box& left = bvh.nodes[1].box;
  const Box& right = bvh.nodes[bvh.nodes[0].first].box;
  EXPECT_TRUE(left.upper.x < right.lower.x || right.upper.x < left.lower.x);
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

// Three chains of boxes, each at a fortieth of the last one's distance: every SAH split takes one place off
// the others, and would still do so with few enough left for a leaf. None is so small that its area is 0.
TEST(Bvh, BoundsTheDepthWhereEachSplitTakesOneOff) {
  for (const int copies : {2, 9}) {
    SCOPED_TRACE(copies);
    std::vector<Box> boxes;
    for (int axis = 0; axis < 3; ++axis) {
      float position = 1e15F;
      for (int place = 0; place < 21; ++place) {
        Box box{glm::vec3(0.0F), glm::vec3(1e-19F)};
        box.lower[axis] = position;
        box.upper[axis] = position * 1.001F;
        boxes.insert(boxes.end(), copies, box);
        position /= 40.0F;
      }
    }
    const Bvh bvh = buildBvh(boxes, 1);
    expectSound(bvh, boxes);
    EXPECT_EQ(measure(bvh).depth, gpu::kMaxBvhDepth);
  }
}

}  // namespace
}  // namespace lavaray
