// The traversal of the BVH.
#ifndef TRAVERSE_GLSL
#define TRAVERSE_GLSL

#include "hit.glsl"
#include "lane_use.glsl"
#include "node.glsl"

// A primitive at the same distance as the nearest one so far may have a box that, by rounding, begins behind
// it. It must be found all the same: it may come earlier in the scene file.
const float kTieMargin = 1.00002;

// Finds for each ray that is there, all of which are alike, the nearest primitive that it hits before hit.t,
// or with `anyHit` any such primitive. Searches below packet.entry. Returns false if the device ended the
// loops before the search was over (see kMaxTraversalSteps).
//
// Each iteration of the inner loop finds which children of a node are entered and takes the next child.
// The loop ends at a leaf, or when nothing waits. A lane that has found its leaf waits for the other lanes of
// its subgroup, so that the leaves are tested together.
//
// Wherever a device may end a loop, `isCut` tells that from a finished search: by a reference that is still
// to an inner node, by primitives of the leaf that are left, and by groups that still wait. None of these is
// a loop's own condition, which compilers take to be false after the loop; and no loop has a second exit,
// since what depends on the exit taken is unknown where the device took none.
bool traverseTogether(const bool anyHit, Packet packet, Approach approach, inout Hit hits[kRaysPerLane],
                      inout uint tests) {
  ShearedRay sheared[kRaysPerLane];
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) sheared[r] = shearedRay(packet.rays[r], approach.axis);
  GroupStack stack;
  for (uint i = 0u; i < kStackSize; ++i) stack.entries[i] = 0u;
  stack.entries[0] = packet.entry;
  bool isCut = false;
  bool over = false;
  uint steps = 0u;
  do {
    if (steps < kMaxTraversalSteps) {  // always true: see traverse
      float tMax[kRaysPerLane];
      [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) tMax[r] = hits[r].t * kTieMargin;
      if (!anyHit) tMax[0] = farthest(hits) * kTieMargin;
      uint reference = takeChild(0u, kNoSlots, stack);
      do {
        if (reference <= kMaxReference) {
          vec4 entry;
          const bvec4 enters = entersChildren(anyHit, approach, reference, tMax, entry);
          const uint entered = enteredSlots(!anyHit, enters, entry);
          if (kCountsTests) ++tests;
          countTurn(anyHit);
          reference = takeChild(reference, entered, stack);
          ++steps;
        }
      } while (reference <= kMaxReference && steps < kMaxTraversalSteps);
      isCut = reference <= kMaxReference;
      uint i = reference & kMaxReference;
      const uint end = isCut || reference == kNoReference ? i : i + (reference >> kLeafShift);
      do {
        if (i < end) {
          hitPrimitive(anyHit, packet, sheared, approach.axis, i, hits);
          if (kCountsTests && i != packet.skipped[0]) ++tests;
          countTurn(anyHit);
          ++i;
        }
      } while (i < end);
      isCut = isCut || i != end;
      // Also at a leaf: the next turn would do nothing, and so would all others.
      over = isCut || reference == kNoReference || steps >= kMaxTraversalSteps ||
             (anyHit && farthest(hits) == kNoRay);
    }
  } while (!over);
  return !isCut && (stack.entries[0] == 0u || (anyHit && farthest(hits) == kNoRay));
}

// As traverseTogether, for any rays: those that are along the first one search together, then come the
// others.
//
// The condition in the loop is always true, by the loop's own condition. But what Mesa 22.3's llvmpipe
// computes in a loop and uses after it, it goes on computing for lanes that have left the loop, unless it is
// assigned under a condition. So do all loops here that end with their condition.
bool traverse(const bool anyHit, Packet packet, inout Hit hits[kRaysPerLane], inout uint tests) {
  bool waits[kRaysPerLane];
  uint left = 0u;
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    waits[r] = hits[r].t > 0.0;
    left += uint(waits[r]);
  }
  bool finished = true;
  do {
    if (anyOf(waits)) {
      uint firstIndex = 0u;
      Ray first = packet.rays[0];
      [[unroll]] for (uint r = kRaysPerLane; r > 0u; --r) {
        if (waits[r - 1u]) {
          firstIndex = r - 1u;
          first = packet.rays[r - 1u];
        }
      }
      bool isIn[kRaysPerLane];
      Hit found[kRaysPerLane];
      [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
        // The first one is in even if it is no number, so that the loop ends.
        isIn[r] = waits[r] && (r == firstIndex || isAlong(anyHit, packet.rays[r], first));
        waits[r] = waits[r] && !isIn[r];
        left -= uint(isIn[r]);
        found[r] = hits[r];
        if (!isIn[r]) found[r].t = kNoRay;
      }
      const Approach approach = approachOf(anyHit, packet.rays, isIn, first);
      finished = traverseTogether(anyHit, packet, approach, found, tests);
      [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
        if (isIn[r]) hits[r] = found[r];
      }
    }
  } while (kRaysPerLane > 1u && finished && anyOf(waits));
  return finished && left == 0u;
}

#endif
