// The renderer's search for hits, for shaders of the tests that trace one ray an invocation.
#ifndef SINGLE_RAY_GLSL
#define SINGLE_RAY_GLSL

#include "shade.glsl"

bool findHit(const bool anyHit, Ray ray, uint skipped, inout Hit hit) {
  Packet packet;
  packet.entry = kRootGroup;
  packet.rays[0] = ray;
  packet.skipped[0] = skipped;
  Hit hits[kRaysPerLane];
  hits[0] = hit;
  uint tests = 0u;
  const bool finished = findHits(anyHit, packet, hits, tests);
  hit = hits[0];
  return finished;
}

// Whether a surface other than `surface`, which the point is on, lies between it and a point of a light.
bool isInShadow(SurfacePoint point, uint surface, vec3 light) {
  float end;
  const Ray ray = shadowRay(point, light, end);
  Hit hit = missUpTo(end > 0.0 ? end : kNoRay);
  findHit(true, ray, surface, hit);
  return hit.surface != kNoSurface;
}

#endif
