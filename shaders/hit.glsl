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
  uint order;    // Primitive::order
};

Hit missUpTo(float tMax) {
  return Hit(tMax, kNoSurface, 0u);
}

// No ray: whatever it is tested against, it misses.
const float kNoRay = -1.0;

// Rays that search the hierarchy together; one whose hit.t is kNoRay is not there.
struct Packet {
  Ray rays[kRaysPerLane];      // without denormal numbers
  uint skipped[kRaysPerLane];  // the surfaces that they never hit
  uint entry;                  // 0, kRootGroup or a packed group that contains all that they can hit
};

bool anyOf(bool values[kRaysPerLane]) {
  bool result = false;
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) result = result || values[r];
  return result;
}

// The largest t at which one of the rays may still hit something; kNoRay if none can.
float farthest(Hit hits[kRaysPerLane]) {
  float t = kNoRay;
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) t = max(t, hits[r].t);
  return t;
}

// Keeps the primitive if it is nearer than `hit` or, at the same distance, earlier in the scene file, so that
// the picture does not depend on the order of the tests. With `anyHit` a ray that hits something is done.
void keepNearer(const bool anyHit, float t, uint index, uint order, inout Hit hit) {
  if (anyHit) {
    if (t < hit.t) hit = Hit(kNoRay, index, order);
  } else if (t < hit.t || (t == hit.t && hit.surface != kNoSurface && order < hit.order)) {
    hit = Hit(t, index, order);
  }
}

// As for the other intersectTriangle, in the scene's axes.
float intersectTriangle(Ray ray, Primitive triangle, out vec3 weights) {
  const uint axis = mainAxis(ray.direction);
  return intersectTriangle(shearedRay(ray, axis), permute(triangle.a, axis), permute(triangle.b, axis),
                           permute(triangle.c, axis), weights);
}

// Tests the packet's rays, whose main axis is `axis`, against a primitive.
void hitPrimitive(const bool anyHit, Packet packet, ShearedRay sheared[kRaysPerLane], uint axis, uint index,
                  inout Hit hits[kRaysPerLane]) {
  const Primitive primitive = fetchPrimitive(index);
  const bool isSphere = kHasSpheres && (!kHasTriangles || primitive.kind == kPrimitiveSphere);
  const vec3 a = permute(primitive.a, axis);
  const vec3 b = permute(primitive.b, axis);
  const vec3 c = permute(primitive.c, axis);
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    float t = kInfinity;
    if (isSphere) {
      t = intersectSphere(packet.rays[r], primitive.a, primitive.b.x);
    } else if (kHasTriangles) {
      vec3 weights;
      t = intersectTriangle(sheared[r], a, b, c, weights);
    }
    if (index != packet.skipped[r]) keepNearer(anyHit, t, index, primitive.order, hits[r]);
  }
}

// Tests every primitive of a scene of few, spheres first, so that no lane computes a test of the other kind
// alongside. To stop at any hit would save nothing, since mostly some ray of the subgroup has none. Returns
// false if the device ended a loop.
bool testEach(const bool anyHit, Packet packet, inout Hit hits[kRaysPerLane], inout uint tests) {
  const bool isThere = farthest(hits) > 0.0;
  uint i = 0u;
  for (; i < kFewSpheres; ++i) {
    const Primitive primitive = fetchPrimitive(i);
    [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
      const float t = intersectSphere(packet.rays[r], primitive.a, primitive.b.x);
      if (i != packet.skipped[r]) keepNearer(anyHit, t, i, primitive.order, hits[r]);
    }
  }
  for (; i < kFewSpheres + kFewTriangles; ++i) {
    const Primitive primitive = fetchPrimitive(i);
    [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
      vec3 weights;
      const float t = intersectTriangle(packet.rays[r], primitive, weights);
      if (i != packet.skipped[r]) keepNearer(anyHit, t, i, primitive.order, hits[r]);
    }
  }
  if (isThere && kCountsTests) tests += i - uint(packet.skipped[0] < i);
  return i == kFewSpheres + kFewTriangles;
}

#endif
