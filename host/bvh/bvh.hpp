#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/uninitialized_vector.hpp"
#include "bvh/box.hpp"

namespace lavaray {

// This room turns a Scene into a GpuScene, the arrays that the shaders read. flatten.hpp is the whole way: it
// collects the primitives (primitives.hpp) in coordinates relative to the camera (frame.hpp), builds a binary
// hierarchy over their boxes (this file), and widens that into the one that is traversed (wide_bvh.hpp). The
// result is a function of the scene alone, whatever the number of threads.

// A binary bounding volume hierarchy as built: it knows boxes, not what is in them. Node 0 is the root. The
// array has gaps with arbitrary contents, so walk it from the root, not by index.
struct BvhNode {
  Box box;
  std::uint32_t count = 0;  // leaf: its primitives are Bvh::order[first .. first + count - 1]
  std::uint32_t first = 0;  // inner node (count 0): the second child; the first one follows the node itself
};

struct Bvh {
  UninitializedVector<BvhNode> nodes;
  UninitializedVector<std::uint32_t> order;  // permutation of the primitives, grouped by leaf
  // Size of the largest group of primitives with a common centroid that had to be split all the same.
  std::uint32_t largestCoincidentGroup = 0;
};

// Builds top-down and chooses each split by the surface area heuristic: over bins where there are many
// primitives (bins.hpp), over every split where there are few (sweep.hpp). `count` must not be 0; boxOf,
// which several threads may call at once, returns a primitive's box, whose coordinates must be finite. No
// path has more than gpu::kMaxBvhDepth inner nodes, no leaf more than gpu::kMaxLeafSize primitives. `threads`
// >= 1 affects the time, never the result.
Bvh buildBvh(std::uint32_t count, const std::function<Box(std::uint32_t)>& boxOf, unsigned threads);
Bvh buildBvh(std::span<const Box> boxes, unsigned threads);

// A single leaf with all primitives, at most gpu::kMaxLeafSize, in their original order.
Bvh oneLeaf(std::span<const Box> boxes);

struct BvhQuality {
  std::size_t innerNodes = 0;
  std::size_t leaves = 0;
  unsigned depth = 0;     // inner nodes on the longest path
  double sahCost = 0.0;   // expected node visits + primitive tests for a random ray that hits the root's box
  double leafSize = 0.0;  // mean
};

BvhQuality measure(const Bvh& bvh);

}  // namespace lavaray
