// What rays hit in the whole scene: primitives first, then planes.
#ifndef FIND_HIT_GLSL
#define FIND_HIT_GLSL

#include "traverse.glsl"

// As for findHits, among the scene's planes alone. Each plane is an object, so surfaces at the same distance
// are told apart by their object's number.
bool hitPlanes(const bool anyHit, Packet packet, inout Hit hits[kRaysPerLane], inout uint tests) {
  const bool hasPrimitives = kHasSpheres || kHasTriangles;
  uint objects[kRaysPerLane];
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    objects[r] = 0u;
    if (hasPrimitives && !anyHit && hits[r].surface != kNoSurface) objects[r] = fetchObject(hits[r].surface);
  }
  uint i = 0u;
  for (; i < kPlaneCount && !(anyHit && farthest(hits) == kNoRay); ++i) {
    const Plane plane = fetchPlane(i);
    const uint surface = i | kPlaneBit;
    [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
      if (kCountsTests && hits[r].t > 0.0 && surface != packet.skipped[r]) ++tests;
      const float t = intersectPlane(packet.rays[r], plane.normal, plane.distance);
      const bool isNearer =
          t < hits[r].t || (t == hits[r].t && hits[r].surface != kNoSurface && plane.object < objects[r]);
      if (isNearer && surface != packet.skipped[r]) {
        hits[r] = Hit(anyHit ? kNoRay : t, surface, 0u);
        objects[r] = plane.object;
      }
    }
  }
  return i == kPlaneCount || (anyHit && farthest(hits) == kNoRay);
}

// Finds for each ray of the packet the nearest surface that it hits before hit.t, or with `anyHit` any such
// surface; never the one that it skips. Returns false if the device ended the loops before the search was
// over.
bool findHits(const bool anyHit, Packet packet, inout Hit hits[kRaysPerLane], inout uint tests) {
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) packet.rays[r] = withoutDenormals(packet.rays[r]);
  bool finished = true;
  if (kFewPrimitives) {
    finished = testEach(anyHit, packet, hits, tests);
  } else if (kHasSpheres || kHasTriangles) {
    finished = traverse(anyHit, packet, hits, tests);
  }
  return finished && hitPlanes(anyHit, packet, hits, tests);
}

#endif
