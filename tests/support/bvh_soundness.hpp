#pragma once

#include <algorithm>
#include <functional>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "bvh/bvh.hpp"
#include "interface.h"

namespace lavaray {

// Walks the whole tree: every primitive stands in exactly one leaf, no leaf is too large, no path too long,
// and every box holds what is below it, tightly.
inline void expectSound(const Bvh& bvh, std::span<const Box> boxes) {
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
      content.extend(visit(index + 1, depth + 1));
      content.extend(visit(node.first, depth + 1));
    }
    EXPECT_EQ(content.lower, node.box.lower);
    EXPECT_EQ(content.upper, node.box.upper);
    return node.box;
  };
  visit(0, 0);
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
  EXPECT_LE(measure(bvh).depth, gpu::kMaxBvhDepth);
}

// Boxes of up to `size` a side, their lower corners within +-spread.
inline std::vector<Box> randomBoxes(std::size_t count, float spread, float size, unsigned seed) {
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

}  // namespace lavaray
