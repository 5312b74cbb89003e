#pragma once

#include <bit>
#include <cstdint>

#include "bvh/primitive_reference.hpp"
#include "interface.h"

namespace lavaray {

// The bounds of some references.
struct Bounds {
  PaddedBox box = emptyBox();
  PaddedBox centroids = emptyBox();  // doubled

  void extend(const Reference& reference) {
    box.extend(reference.box);
    centroids.extend(reference.box.doubledCentroid());
  }
  void extend(const Bounds& bounds) {
    box.extend(bounds.box);
    centroids.extend(bounds.centroids);
  }
};

// References that become a subtree: those from `first` on, of which the leaves get the same places in
// Bvh::order. The subtree's root is `node`, its other nodes are among the 2 count - 2 after that.
struct Range {
  std::uint32_t node;
  std::uint32_t first;
  std::uint32_t count;
  std::uint32_t depth;  // inner nodes above
  Bounds bounds;
};

// Halvings that bring `count` primitives down to leaves.
inline std::uint32_t levelsNeeded(std::uint32_t count) {
  const std::uint32_t leaves = (count + gpu::kMaxLeafSize - 1) / gpu::kMaxLeafSize;
  return static_cast<std::uint32_t>(std::bit_width(leaves - 1));
}

// Whether `count` primitives with `depth` inner nodes above may be divided as it pleases, even into one and
// the others. Where not, only halving them keeps the depth in bounds.
inline bool depthAllowsAnySplit(std::uint32_t depth, std::uint32_t count) {
  return depth + levelsNeeded(count) < gpu::kMaxBvhDepth;
}

}  // namespace lavaray
