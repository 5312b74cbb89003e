// A node of the BVH: which of its children are entered, and which are still to be visited.
#ifndef NODE_GLSL
#define NODE_GLSL

#include "beam.glsl"

// Four bounds of boxes, one byte each, in a node's frame.
vec4 decodeBounds(uint bounds, float origin, float unit) {
  return vec4((uvec4(bounds) >> uvec4(0u, 8u, 16u, 24u)) & 255u) * unit + origin;
}

// Which of the node's children one of the rays enters; where they do not look for any hit, also the distances
// at which their beam does. `tMax` is for each beam.
bvec4 entersChildren(const bool anyHit, Approach approach, uint index, float tMax[kRaysPerLane],
                     out vec4 entry) {
  const BvhNode node = fetchNode(index);
  const uvec3 nearBounds = mix(node.lower, node.upper, approach.negative);
  const uvec3 farBounds = mix(node.upper, node.lower, approach.negative);
  vec4 near[3];
  vec4 far[3];
  [[unroll]] for (int axis = 0; axis < 3; ++axis) {
    const float unit = uintBitsToFloat(((node.exponents >> (8 * axis)) & 255u) << 23);
    near[axis] = decodeBounds(nearBounds[axis], node.origin[axis], unit);
    far[axis] = decodeBounds(farBounds[axis], node.origin[axis], unit);
  }
  uvec4 enters = uvec4(entersBoxes(approach.beams[0], near, far, tMax[0], entry));
  if (anyHit) {
    [[unroll]] for (uint r = 1u; r < kRaysPerLane; ++r) {
      vec4 ignored;
      enters |= uvec4(entersBoxes(approach.beams[r], near, far, tMax[r], ignored));
    }
  }
  return bvec4(enters);
}

// The slots of the children that are entered: in the order of these distances, nearest first or, where that
// does not matter, in their own. A distance is at least 0, so its bits compare as it does itself; the lowest
// two give way to the slot.
uint enteredSlots(const bool sorts, bvec4 enters, vec4 entry) {
  const uvec4 isEntered = uvec4(enters);
  const uint end = kNoSlots << kBitsPerSlot * (isEntered.x + isEntered.y + isEntered.z + isEntered.w);
  if (!sorts) {
    uint slots = kNoSlots;
    [[unroll]] for (int slot = 3; slot >= 0; --slot) slots =
        isEntered[slot] != 0u ? slots << kBitsPerSlot | uint(slot) : slots;
    return slots;
  }
  const vec4 known = mix(vec4(kInfinity), entry, enters);
  uvec4 keys = (floatBitsToUint(known) & ~3u) | uvec4(0u, 1u, 2u, 3u);
  keys = uvec4(min(keys.x, keys.y), max(keys.x, keys.y), min(keys.z, keys.w), max(keys.z, keys.w));
  keys = uvec4(min(keys.x, keys.z), min(keys.y, keys.w), max(keys.x, keys.z), max(keys.y, keys.w));
  keys = uvec4(keys.x, min(keys.y, keys.z), max(keys.y, keys.z), keys.w) & 3u;
  const uint slots = keys.x | keys.y << 2u | keys.z << 4u | keys.w << 6u;
  return (slots & (end - 1u)) | end;
}

// The packed groups that wait, the last one in entry 0. A push or pop moves all entries along, since constant
// indices keep them in registers: on lavapipe a write to a computed index is a branch per lane, and took two
// thirds of the time.
struct GroupStack {
  uint entries[kStackSize];
};

const uint kNoReference = 0xFFFFFFFFu;  // to a node or a leaf

// Takes the next child to visit: the first one that is entered of `node`, or, where there is none, the last
// group's first. Returns its reference, or kNoReference where nothing waits.
uint takeChild(uint node, uint entered, inout GroupStack stack) {
  const bool pops = entered == kNoSlots;
  const uint top = stack.entries[0];
  const uvec4 children = fetchChildren(pops ? top >> kGroupNodeShift : node);
  const uint slots = pops ? top : entered;
  const uint child = (slots & 2u) == 0u ? ((slots & 1u) == 0u ? children.x : children.y)
                                        : ((slots & 1u) == 0u ? children.z : children.w);
  const uint topRest = (top & 0xFFu) >> kBitsPerSlot;
  const uint enteredRest = entered >> kBitsPerSlot;
  const bool up = enteredRest > kNoSlots;
  const bool down = pops && topRest <= kNoSlots;
  const uint first = pops ? (top & ~0xFFu) | topRest : top;
  uint above = node << kGroupNodeShift | enteredRest;
  for (uint i = 0u; i < kStackSize; ++i) {
    const uint entry = i == 0u ? first : stack.entries[i];
    const uint old = stack.entries[i];
    const uint below = i + 1u < kStackSize ? stack.entries[i + 1u] : 0u;
    stack.entries[i] = up ? above : (down ? below : entry);
    above = old;
  }
  return pops && top == 0u ? kNoReference : child;
}

#endif
