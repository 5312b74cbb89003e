#pragma once

#include <cstdint>

#include "base/uninitialized_vector.hpp"
#include "bvh/bvh.hpp"
#include "interface.h"

namespace lavaray {

// The tree as traversed: inner nodes with up to four children each, whose boxes are quantised to 8 bits per
// bound.
struct WideBvh {
  // Node 0 is above the root: its only child is the root, be that an inner node or a leaf. Then come the
  // upper levels, then one subtree after another, all of these depth first.
  UninitializedVector<gpu::BvhNode> nodes;
  UninitializedVector<std::uint32_t> order;  // the primitives in the order of the leaves
  std::uint32_t depth = 0;                   // inner nodes on the longest path
};

// Each node of the result replaces up to three of `bvh`. Throws Error(kInput) if there are more nodes than a
// node reference can address. `threads` affects the time, never the result.
WideBvh widen(const Bvh& bvh, unsigned threads);

// A packed group of one child, and the first one of a group.
constexpr gpu::uint groupOf(gpu::uint node, gpu::uint slot) {
  return node << gpu::kGroupNodeShift | gpu::kNoSlots << gpu::kBitsPerSlot | slot;
}
constexpr gpu::uint firstSlot(gpu::uint group) {
  return group & ((1U << gpu::kBitsPerSlot) - 1U);
}

// The box of a node's child, exactly as the shader decodes it; for tests.
Box childBox(const gpu::BvhNode& node, int child);

}  // namespace lavaray
