#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/uninitialized_vector.hpp"
#include "bvh/box.hpp"

namespace lavaray {

// A binary bounding volume hierarchy as it is built: it knows boxes, not what is in them. Node 0 is the root.
// The array has gaps of any content, so it is walked from the root and not by index.
struct BvhNode {
  Box box;
  std::uint32_t count = 0;  // of a leaf: its primitives, Bvh::order[first .. first + count - 1]
  std::uint32_t first = 0;
  std::uint32_t left = 0;  // of an inner node (count 0): its children
  std::uint32_t right = 0;
};

struct Bvh {
  UninitializedVector<BvhNode> nodes;
  UninitializedVector<std::uint32_t> order;  // permutation of the primitives, grouped by leaf
  // Size of the largest group of primitives with one common centroid that had to be divided all the same.
  std::uint32_t largestCoincidentGroup = 0;
};

// Builds top-down, choosing each split by the surface area heuristic: over bins where there are many
// primitives (bvh_bins.hpp), over all splits where there are few (bvh_sweep.hpp). `boxes` is not empty and
// its coordinates are finite. No path has more than gpu::kMaxBvhDepth inner nodes and no leaf more than
// gpu::kMaxLeafSize primitives. `threads` >= 1 changes the time, never the result.
Bvh buildBvh(std::span<const Box> boxes, unsigned threads);

// A leaf of all primitives, gpu::kMaxLeafSize at most, in their order.
Bvh oneLeaf(std::span<const Box> boxes);

struct BvhQuality {
  std::size_t innerNodes = 0;
  std::size_t leaves = 0;
  unsigned depth = 0;     // inner nodes on the longest path
  double sahCost = 0.0;   // expected node visits + primitive tests of a random ray that hits the root's box
  double leafSize = 0.0;  // mean
};

BvhQuality measure(const Bvh& bvh);

}  // namespace lavaray
