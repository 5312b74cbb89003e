// What a ray hits: the BVH's primitives, then the planes.
#ifndef TRAVERSE_GLSL
#define TRAVERSE_GLSL

#include "intersect.glsl"
#include "scene_data.glsl"

// A surface is a primitive's index or a plane's with kPlaneBit.
const uint kPlaneBit = 0x80000000u;
const uint kNoSurface = 0xFFFFFFFFu;

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
// The nearer child is visited first, the other one waits on the stack. `finished` is set where the search
// ends and nowhere else, so a loop that was cut short is noticed, the one over a leaf's primitives included.
bool traverse(const bool anyHit, Ray ray, uint skipped, uint root, inout Hit hit) {
  const RayConstants constants = rayConstants(ray);
  uint stack[kMaxBvhDepth];
  int stackSize = 0;
  uint reference = root;
  bool finished = false;
  for (uint step = 0u; step < kMaxTraversalSteps && !finished; ++step) {
    if (reference > kMaxReference) {
      const uint first = reference & kMaxReference;
      const uint end = first + (reference >> kLeafShift);
      uint i = first;
      for (; i < end && !(anyHit && hit.surface != kNoSurface); ++i) {
        if (i != skipped) hitPrimitive(ray, constants, i, hit);
      }
      if (anyHit && hit.surface != kNoSurface) {
        finished = true;
      } else if (i < end) {
        return false;
      }
    } else {
      const BvhNode node = fetchNode(reference);
      const float entry0 = intersectBox(ray, constants, node.lower0, node.upper0, hit.t);
      const float entry1 = intersectBox(ray, constants, node.lower1, node.upper1, hit.t);
      const bool swapped = entry1 < entry0;
      const float nearEntry = swapped ? entry1 : entry0;
      const float farEntry = swapped ? entry0 : entry1;
      if (farEntry < kInfinity) stack[stackSize++] = swapped ? node.child0 : node.child1;
      if (nearEntry < kInfinity) {
        reference = swapped ? node.child1 : node.child0;
        continue;
      }
    }
    finished = finished || stackSize == 0;
    if (!finished) reference = stack[--stackSize];
  }
  return finished;
}

// The same for the scene as a whole. A plane is an object of its own, so it is compared by object.
bool findHit(const bool anyHit, Ray ray, uint skipped, uint root, inout Hit hit) {
  if (kHasSpheres || kHasTriangles) {
    if (!traverse(anyHit, ray, skipped, root, hit)) return false;
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
