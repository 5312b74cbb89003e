// The tree as traversed against the tree as built, in exact arithmetic: sides are float32 numbers, so
// comparing them rounds nothing.
#include "bvh/wide_bvh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lavaray {
namespace {

bool contains(const Box& outer, const Box& inner) {
  return glm::all(glm::lessThanEqual(outer.lower, inner.lower)) &&
         glm::all(glm::greaterThanEqual(outer.upper, inner.upper));
}

// Of what lies below a reference; checks on the way that each node's boxes contain it, and counts how often
// each primitive is reached.
class Walker {
 public:
  Walker(const WideBvh& bvh, const std::vector<Box>& boxes)
      : bvh_(bvh), boxes_(boxes), reached_(boxes.size()) {}

  void run() {
    bounds(0, 0);
    for (const int count : reached_) EXPECT_EQ(count, 1);
    EXPECT_EQ(deepest_, bvh_.depth);
    EXPECT_EQ(escaped_, 0U);
  }
  // Mean over the children of surface area, as stored over as it is.
  [[nodiscard]] double growth() const { return storedArea_ / area_; }

 private:
  Box bounds(gpu::uint reference, std::uint32_t nodesAbove) {
    Box result;
    if (reference > gpu::kMaxReference) {
      const gpu::uint first = reference & gpu::kMaxReference;
      for (gpu::uint i = first; i < first + (reference >> gpu::kLeafShift); ++i) {
        ++reached_.at(bvh_.order.at(i));
        result.extend(boxes_[bvh_.order[i]]);
      }
      return result;
    }
    // The node above the root is not counted.
    deepest_ = std::max(deepest_, nodesAbove);
    const gpu::BvhNode& node = bvh_.nodes.at(reference);
    for (int i = 0; i < 4; ++i) {
      const Box stored = childBox(node, i);
      if (glm::any(glm::greaterThan(stored.lower, stored.upper))) {
        EXPECT_EQ(node.children[i], gpu::kMissingChild);
        continue;
      }
      const Box below = bounds(node.children[i], nodesAbove + 1);
      escaped_ += contains(stored, below) ? 0 : 1;
      storedArea_ += double{halfArea(stored)};
      area_ += double{halfArea(below)};
      result.extend(below);
    }
    return result;
  }

  const WideBvh& bvh_;
  const std::vector<Box>& boxes_;
  std::vector<int> reached_;
  std::uint32_t deepest_ = 0;
  std::size_t escaped_ = 0;
  double storedArea_ = 0.0;
  double area_ = 0.0;
};

std::vector<Box> randomBoxes(std::size_t count, float center, float spread, float size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1.0F, 1.0F);
  const auto vector = [&] { return glm::vec3(uniform(random), uniform(random), uniform(random)); };
  std::vector<Box> boxes(count);
  for (Box& box : boxes) {
    const glm::vec3 middle = glm::vec3(center) + spread * vector();
    box.extend(middle);
    box.extend(middle + size * vector());
  }
  return boxes;
}

TEST(WideBvh, ContainsWhatItBoundsAtAnyScaleAndPlace) {
  for (const float scale : {1e-30F, 1e-6F, 1.0F, 1e6F, 1e15F}) {
    for (const float center : {0.0F, 10.0F, 1e5F}) {
      for (const float size : {0.0F, 0.01F, 0.5F}) {
        const std::vector<Box> boxes = randomBoxes(500, center * scale, scale, size * scale, 1);
        const WideBvh wide = widen(buildBvh(boxes, 1), 1);
        Walker(wide, boxes).run();
      }
    }
  }
}

// Flat boxes, points, denormal numbers, and boxes that share a corner with the largest coordinate.
TEST(WideBvh, ContainsDegenerateBoxes) {
  std::vector<Box> boxes;
  for (int i = 0; i < 40; ++i) {
    const auto x = static_cast<float>(i);
    Box box;
    box.extend(glm::vec3(x, 0.0F, -1e-40F * x));
    box.extend(glm::vec3(x + static_cast<float>(i % 2), 0.0F, 1e-40F * x));
    boxes.push_back(box);
    Box far;
    far.extend(glm::vec3(2e15F, 2e15F, 1e-38F));
    far.extend(glm::vec3(std::nextafter(2e15F, 0.0F), 2e15F - 1e9F * x, 0.0F));
    boxes.push_back(far);
  }
  Walker(widen(buildBvh(boxes, 1), 1), boxes).run();
}

// A sphere that touches a coordinate plane reaches a denormal number past it, which is lost in a difference
// to the far side of its box. Found by the fuzzer.
TEST(WideBvh, ContainsBoxesThatEndJustPastZero) {
  for (const float far : {10.0F, 3.0F * 0x1p-20F, 1e15F, 255.0F}) {
    for (const float near : {0x1p-149F, 1e-30F, 1e-12F}) {
      std::vector<Box> boxes;
      for (int i = 0; i < 20; ++i) {
        const float side = far * (1.0F + static_cast<float>(i));
        boxes.push_back({glm::vec3(-side, -near, -side), glm::vec3(near, side, -near)});
        boxes.push_back({glm::vec3(-near, -side, near), glm::vec3(side, near, side)});
      }
      const WideBvh wide = widen(buildBvh(boxes, 1), 1);
      Walker(wide, boxes).run();
    }
  }
}

TEST(WideBvh, IsNotMuchWiderThanItsContent) {
  const std::vector<Box> boxes = randomBoxes(20000, 0.0F, 1.0F, 0.01F, 2);
  const WideBvh wide = widen(buildBvh(boxes, 2), 2);
  Walker walker(wide, boxes);
  walker.run();
  EXPECT_LT(walker.growth(), 1.05);
  std::cout << "surface " << walker.growth() << " times the content's, " << wide.nodes.size() << " nodes for "
            << boxes.size() << " boxes, depth " << wide.depth << '\n';
}

}  // namespace
}  // namespace lavaray
