#pragma once

#include <bit>
#include <cstdint>

#include "bvh/primitive_reference.hpp"
#include "interface.h"

namespace lavaray {

// Of a set of references.
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

// References that become a subtree: `count` of them from index `first` on, and its leaves fill the same
// indices of Bvh::order. The subtree's root is `node`; its other nodes are among the 2 count - 2 that follow.
struct Range {
  std::uint32_t node;
  std::uint32_t first;
  std::uint32_t count;
  std::uint32_t depth;  // number of inner nodes above
  Bounds bounds;
};

// How many halvings reduce `count` primitives to leaves.
inline std::uint32_t levelsNeeded(std::uint32_t count) {
  const std::uint32_t leaves = (count + gpu::kMaxLeafSize - 1) / gpu::kMaxLeafSize;
  return static_cast<std::uint32_t>(std::bit_width(leaves - 1));
}

// Whether `count` primitives below `depth` inner nodes may be split at will, even into one and all the
// others. If not, only halving them keeps the tree within its depth limit.
inline bool depthAllowsAnySplit(std::uint32_t depth, std::uint32_t count) {
  return depth + levelsNeeded(count) < gpu::kMaxBvhDepth;
}

}  // namespace lavaray
