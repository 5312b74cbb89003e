// A node of the BVH: which of its children a ray enters, and which are still to be visited.
#ifndef NODE_GLSL
#define NODE_GLSL

#include "intersect.glsl"
#include "scene_data.glsl"

// Four bounds of boxes, one byte each, in a node's frame.
vec4 decodeBounds(uint bounds, float origin, float unit) {
  return vec4((uvec4(bounds) >> uvec4(0u, 8u, 16u, 24u)) & 255u) * unit + origin;
}

// Where the ray enters the boxes of the node's children; as for intersectBoxes.
vec4 enterChildren(Ray ray, RayConstants constants, uint index, float tMax) {
  const BvhNode node = fetchNode(index);
  const uvec3 nearBounds = mix(node.lower, node.upper, constants.negative);
  const uvec3 farBounds = mix(node.upper, node.lower, constants.negative);
  vec4 near[3];
  vec4 far[3];
  for (int axis = 0; axis < 3; ++axis) {
    const float unit = uintBitsToFloat(((node.exponents >> (8 * axis)) & 255u) << 23);
    near[axis] = decodeBounds(nearBounds[axis], node.origin[axis], unit);
    far[axis] = decodeBounds(farBounds[axis], node.origin[axis], unit);
  }
  return intersectBoxes(ray, constants, near, far, tMax);
}

// The children of a node that are still to be visited: `count` slots of two bits each, the nearest one
// lowest.
struct NodeGroup {
  uint node;
  uint slots;
  uint count;
};

// The children that are entered at these distances, nearest first. A distance is at least 0, so its bits
// compare as it does itself; the lowest two give way to the slot.
NodeGroup sortedGroup(uint node, vec4 entry) {
  const bvec4 hits = lessThan(entry, vec4(kInfinity));
  uvec4 keys = (floatBitsToUint(entry) & ~3u) | uvec4(0u, 1u, 2u, 3u);
  keys = uvec4(min(keys.x, keys.y), max(keys.x, keys.y), min(keys.z, keys.w), max(keys.z, keys.w));
  keys = uvec4(min(keys.x, keys.z), min(keys.y, keys.w), max(keys.x, keys.z), max(keys.y, keys.w));
  keys = uvec4(keys.x, min(keys.y, keys.z), max(keys.y, keys.z), keys.w) & 3u;
  const uint slots = keys.x | keys.y << 2u | keys.z << 4u | keys.w << 6u;
  return NodeGroup(node, slots, uint(hits.x) + uint(hits.y) + uint(hits.z) + uint(hits.w));
}

// The packed groups that wait, the last one in entry 0. A push or pop moves all entries along, since constant
// indices keep them in registers: on lavapipe a write to a computed index is a branch per lane, and took two
// thirds of the time.
struct GroupStack {
  uint entries[kStackSize];
};

uint packGroup(NodeGroup group) {
  return group.node << kGroupNodeShift | group.slots << kGroupSlotsShift | group.count;
}
NodeGroup unpackGroup(uint entry) {
  return NodeGroup(entry >> kGroupNodeShift, (entry >> kGroupSlotsShift) & 63u, entry & 3u);
}

// Pops the last group if `pop`, then pushes one if `push`.
void updateStack(inout GroupStack stack, bool pop, bool push, NodeGroup added) {
  const bool up = push && !pop;
  const bool down = pop && !push;
  uint above = packGroup(added);
  const uint first = pop && push ? above : stack.entries[0];
  for (uint i = 0u; i < kStackSize; ++i) {
    const uint entry = i == 0u ? first : stack.entries[i];
    const uint below = i + 1u < kStackSize ? stack.entries[i + 1u] : 0u;
    stack.entries[i] = up ? above : (down ? below : entry);
    above = entry;
  }
}

#endif
