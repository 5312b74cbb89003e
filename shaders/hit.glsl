// What a ray hits, and the tests against single primitives.
#ifndef HIT_GLSL
#define HIT_GLSL

#include "intersect.glsl"
#include "scene_data.glsl"
#include "tests.glsl"

// A surface is a primitive's index, or a plane's index with kPlaneBit.
const uint kPlaneBit = 0x80000000u;
const uint kNoSurface = 0xFFFFFFFFu;

struct Hit {
  float t;       // in lengths of the ray's direction
  uint surface;  // or kNoSurface
  uint object;
  uint order;    // Primitive::order
  vec3 weights;  // barycentric coordinates in a triangle
};

Hit missUpTo(float tMax) {
  return Hit(tMax, kNoSurface, 0u, 0u, vec3(0.0));
}

// Keeps the primitive if it is nearer than `hit` or, at the same distance, earlier in the scene file, so that
// the picture does not depend on the order of the tests.
void keepNearer(float t, uint index, Primitive primitive, vec3 weights, inout Hit hit) {
  if (t < hit.t || (t == hit.t && hit.surface != kNoSurface && primitive.order < hit.order)) {
    hit = Hit(t, index, primitive.object, primitive.order, weights);
  }
}

void hitPrimitive(Ray ray, RayConstants constants, uint index, inout Hit hit) {
  const Primitive primitive = fetchPrimitive(index);
  vec3 weights = vec3(0.0);
  float t = kInfinity;
  if (kHasSpheres && (!kHasTriangles || primitive.kind == kPrimitiveSphere)) {
    t = intersectSphere(ray, primitive.a, primitive.b.x);
  } else if (kHasTriangles) {
    t = intersectTriangle(ray, constants, primitive.a, primitive.b, primitive.c, weights);
  }
  keepNearer(t, index, primitive, weights, hit);
}

// Tests every primitive of a scene of few, spheres first, so that no lane computes a test of the other kind
// alongside. To stop at any hit would save nothing, since mostly some ray of the subgroup has none. Returns
// false if the device ended a loop.
bool testEach(Ray ray, uint skipped, inout Hit hit, inout uint tests) {
  const RayConstants constants = rayConstants(ray);
  uint i = 0u;
  for (; i < kFewSpheres; ++i) {
    const Primitive primitive = fetchPrimitive(i);
    const float t = intersectSphere(ray, primitive.a, primitive.b.x);
    if (i != skipped) keepNearer(t, i, primitive, vec3(0.0), hit);
  }
  for (; i < kFewSpheres + kFewTriangles; ++i) {
    const Primitive primitive = fetchPrimitive(i);
    vec3 weights;
    const float t = intersectTriangle(ray, constants, primitive.a, primitive.b, primitive.c, weights);
    if (i != skipped) keepNearer(t, i, primitive, weights, hit);
  }
  if (kCountsTests) tests += i - uint(skipped < i);
  return i == kFewSpheres + kFewTriangles;
}

#endif
