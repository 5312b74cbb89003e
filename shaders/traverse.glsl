// The traversal of the BVH.
#ifndef TRAVERSE_GLSL
#define TRAVERSE_GLSL

#include "hit.glsl"
#include "node.glsl"

const uint kNoReference = 0xFFFFFFFFu;  // to a node or a leaf

// Finds the nearest primitive that the ray hits before hit.t, or with `anyHit` any such primitive; never the
// one named `skipped`. Searches below the packed group `entry`, which is kRootGroup or contains all that the
// ray can hit. Returns false if the device ended the loops before the search was over (see
// kMaxTraversalSteps).
//
// Each iteration of the inner loop takes the nearest waiting child and, if that is an inner node, finds which
// of its children the ray enters. The loop ends at a leaf, or when nothing waits. A lane that has found its
// leaf waits for the other lanes of its subgroup, so that the leaves are tested together.
//
// Wherever a device may force an exit, it can be told from a finished search: by a reference that is still to
// an inner node, by primitives of the leaf that are left, and by `over`.
bool traverse(const bool anyHit, Ray ray, uint skipped, uint entry, inout Hit hit, inout uint tests) {
  const RayConstants constants = rayConstants(ray);
  GroupStack stack;
  for (uint i = 0u; i < kStackSize; ++i) stack.entries[i] = 0u;
  NodeGroup group = unpackGroup(entry);
  bool over = false;
  uint steps = 0u;
  do {
    uint reference = 0u;
    do {
      // Always true, by the loop's own condition. But without it Mesa 22.3's llvmpipe recomputes `reference`
      // in later iterations for lanes that have left the loop.
      if (steps < kMaxTraversalSteps) {
        const bool pop = group.count == 0u;
        if (pop) group = unpackGroup(stack.entries[0]);
        over = group.count == 0u;
        const uvec4 children = fetchChildren(group.node);
        const uint slot = group.slots & 3u;
        const uint child =
            slot < 2u ? (slot == 0u ? children.x : children.y) : (slot == 2u ? children.z : children.w);
        reference = over ? kNoReference : child;
        group.slots >>= 2u;
        group.count -= over ? 0u : 1u;
        const bool isNode = reference <= kMaxReference;
        updateStack(stack, pop, isNode && group.count > 0u, group);
        const uint node = isNode ? reference : 0u;
        const NodeGroup entered = sortedGroup(node, enterChildren(ray, constants, node, hit.t));
        if (isNode) group = entered;
        if (kCountsTests && isNode) ++tests;
        ++steps;
      }
    } while (reference <= kMaxReference && steps < kMaxTraversalSteps);
    if (reference <= kMaxReference) return false;
    uint i = reference & kMaxReference;
    const uint end = over ? i : i + (reference >> kLeafShift);
    while (i < end) {
      if (i != skipped) hitPrimitive(ray, constants, i, hit);
      if (kCountsTests && i != skipped) ++tests;
      ++i;
    }
    if (i < end) return false;
    over = over || (anyHit && hit.surface != kNoSurface);
  } while (!over);
  return over;
}

#endif
