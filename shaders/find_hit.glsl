// What a ray hits in the whole scene: primitives first, then planes.
#ifndef FIND_HIT_GLSL
#define FIND_HIT_GLSL

#include "traverse.glsl"

// Finds the nearest surface that the ray hits before hit.t, or with `anyHit` any such surface; never the one
// named `skipped`. `entry` is as for traverse. Each plane is an object, so planes at the same distance are
// told apart by their object's number. Returns false if the device ended the loops before the search was
// over.
bool findHit(const bool anyHit, Ray given, uint skipped, uint entry, inout Hit hit, inout uint tests) {
  const Ray ray = withoutDenormals(given);
  if (kFewPrimitives) {
    if (!testEach(ray, skipped, hit, tests)) return false;
  } else if (kHasSpheres || kHasTriangles) {
    if (!traverse(anyHit, ray, skipped, entry, hit, tests)) return false;
  }
  uint i = 0u;
  for (; i < kPlaneCount && !(anyHit && hit.surface != kNoSurface); ++i) {
    if ((i | kPlaneBit) == skipped) continue;
    if (kCountsTests) ++tests;
    const Plane plane = fetchPlane(i);
    const float t = intersectPlane(ray, plane.normal, plane.distance);
    if (t < hit.t || (t == hit.t && hit.surface != kNoSurface && plane.object < hit.object)) {
      hit = Hit(t, i | kPlaneBit, plane.object, 0u, vec3(0.0));
    }
  }
  return i == kPlaneCount || (anyHit && hit.surface != kNoSurface);
}

#endif
