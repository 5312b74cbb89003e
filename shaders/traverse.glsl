// What a ray hits: the BVH's primitives, then the planes.
#ifndef TRAVERSE_GLSL
#define TRAVERSE_GLSL

#include "node.glsl"

// A surface is a primitive's index or a plane's with kPlaneBit.
const uint kPlaneBit = 0x80000000u;
const uint kNoSurface = 0xFFFFFFFFu;
const uint kNoReference = 0xFFFFFFFFu;  // of a node or a leaf

struct Hit {
  float t;       // in lengths of the ray's direction
  uint surface;  // or kNoSurface
  uint object;
  uint order;    // of a primitive, see there
  vec3 weights;  // of a triangle: barycentric coordinates
};

Hit missUpTo(float tMax) { return Hit(tMax, kNoSurface, 0u, 0u, vec3(0.0)); }

// Tests one primitive and keeps it if it is nearer than `hit` or, at the same distance, stands before it in
// the scene file: so the picture does not depend on the order of traversal.
void hitPrimitive(Ray ray, RayConstants constants, uint index, inout Hit hit) {
  const Primitive primitive = fetchPrimitive(index);
  vec3 weights = vec3(0.0);
  float t = kInfinity;
  if (kHasSpheres && (!kHasTriangles || primitive.kind == kSphere)) {
    t = intersectSphere(ray, primitive.a, primitive.b.x);
  } else if (kHasTriangles) {
    t = intersectTriangle(ray, constants, primitive.a, primitive.b, primitive.c, weights);
  }
  if (t < hit.t || (t == hit.t && hit.surface != kNoSurface && primitive.order < hit.order)) {
    hit = Hit(t, index, primitive.object, primitive.order, weights);
  }
}

// Finds the first primitive that the ray hits before hit.t, or any one of them if `anyHit`; not the one named
// `skipped`. Returns false if the device ended the loops before the search was over (see kMaxTraversalSteps).
//
// One turn of the inner loop takes the nearest child that waits and, if it is an inner node, finds which of its
// children the ray enters; the loop ends at a leaf, or where nothing waits. A lane that has its leaf waits for
// those of its subgroup that have not: so the tests of the leaves are done together.
//
// Each exit that a device may force is told from a search that is over: by a reference to an inner node, a leaf's
// primitives that are left, and `over`.
bool traverse(const bool anyHit, Ray ray, uint skipped, inout Hit hit) {
  const RayConstants constants = rayConstants(ray);
  GroupStack stack;
  for (uint i = 0u; i < kStackSize; ++i) stack.entries[i] = 0u;
  NodeGroup group = NodeGroup(0u, 0u, 1u);  // the node above the root
  bool over = false;
  uint steps = 0u;
  do {
    uint reference = 0u;
    do {
      // Always true, as the loop's condition says it too. But without it Mesa 22.3's llvmpipe computes `reference`
      // anew in later turns for lanes that have left the loop.
      if (steps < kMaxTraversalSteps) {
        const bool pop = group.count == 0u;
        if (pop) group = unpackGroup(stack.entries[0]);
        over = group.count == 0u;
        const uvec4 children = fetchChildren(group.node);
        const uint slot = group.slots & 3u;
        const uint child = slot < 2u ? (slot == 0u ? children.x : children.y) : (slot == 2u ? children.z : children.w);
        reference = over ? kNoReference : child;
        group.slots >>= 2u;
        group.count -= over ? 0u : 1u;
        const bool isNode = reference <= kMaxReference;
        updateStack(stack, pop, isNode && group.count > 0u, group);
        const uint node = isNode ? reference : 0u;
        const NodeGroup entered = sortedGroup(node, enterChildren(ray, constants, node, hit.t));
        if (isNode) group = entered;
        ++steps;
      }
    } while (reference <= kMaxReference && steps < kMaxTraversalSteps);
    if (reference <= kMaxReference) return false;
    uint i = reference & kMaxReference;
    const uint end = over ? i : i + (reference >> kLeafShift);
    while (i < end) {
      if (i != skipped) hitPrimitive(ray, constants, i, hit);
      ++i;
    }
    if (i < end) return false;
    over = over || (anyHit && hit.surface != kNoSurface);
  } while (!over);
  return over;
}

// The same for the scene as a whole. A plane is an object of its own, so it is compared by object.
bool findHit(const bool anyHit, Ray ray, uint skipped, inout Hit hit) {
  if (kHasSpheres || kHasTriangles) {
    if (!traverse(anyHit, ray, skipped, hit)) return false;
  }
  uint i = 0u;
  for (; i < kPlaneCount && !(anyHit && hit.surface != kNoSurface); ++i) {
    if ((i | kPlaneBit) == skipped) continue;
    const Plane plane = planes[i];
    const float t = intersectPlane(ray, plane.normal, plane.distance);
    if (t < hit.t || (t == hit.t && hit.surface != kNoSurface && plane.object < hit.object)) {
      hit = Hit(t, i | kPlaneBit, plane.object, 0u, vec3(0.0));
    }
  }
  return i == kPlaneCount || (anyHit && hit.surface != kNoSurface);
}

#endif
