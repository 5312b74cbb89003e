// One sample of a pixel: what a camera ray, and the mirror rays that continue it, see.
#ifndef PATH_GLSL
#define PATH_GLSL

#include "illumination.glsl"
#include "view.glsl"

// The part of a path between two of its vertices.
struct Segment {
  Ray ray;
  uint skipped;  // the surface that the ray leaves
  uint entry;    // Packet::entry, the same for all segments
  bool isThere;  // until the path ends
  vec3 weight;   // the product of the mirrors' reflectances so far
};

// Finds what a segment hits and what can be seen there; nothing where it is not there or hits nothing.
bool findPoints(Segment segments[kRaysPerLane], out Hit hits[kRaysPerLane], inout uint tests,
                out ShadingPoint points[kRaysPerLane]) {
  Packet packet;
  packet.entry = segments[0].entry;
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    packet.rays[r] = segments[r].ray;
    packet.skipped[r] = segments[r].skipped;
    hits[r] = missUpTo(segments[r].isThere ? kInfinity : kNoRay);
  }
  if (!findHits(false, packet, hits, tests)) return false;
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    points[r].surface = hits[r].surface;
    if (isThere(points[r])) {
      points[r].at = surfacePoint(segments[r].ray, hits[r]);
      points[r].material = fetchMaterial(points[r].at.object);
      points[r].toViewer = -unit(segments[r].ray.direction);
      points[r].weight = segments[r].weight;
    }
  }
  return true;
}

// The reflection of a segment at the point that it hits; it is not there where it would add nothing.
Segment reflection(Segment segment, ShadingPoint point) {
  // Kept finite: an infinite weight times a colour of 0 would be a NaN.
  segment.weight = min(segment.weight * point.material.reflectance, vec3(3.4e38));
  segment.isThere = isThere(point) && !(maxComponent(segment.weight) < kMinReflectance);
  const vec3 incoming = unit(segment.ray.direction);
  const vec3 normal = point.at.shadingNormal;
  const vec3 direction = incoming - 2.0 * preciseDot(incoming, normal) * normal;
  segment.ray = Ray(leave(point.at, direction), direction);
  segment.skipped = point.surface;
  segment.entry = kRootGroup;
  return segment;
}

// Finds what the segments hit, adds what that shows and replaces the segments with their reflections, or sets
// `ended`. Returns false where it could not finish; `state` then says what is missing.
bool followSegments(inout Segment segments[kRaysPerLane], uint bounce, PathSettings settings[kRaysPerLane],
                    inout PathState state, inout RayCounts counts, out bool ended) {
  ended = true;
  Hit hits[kRaysPerLane];
  ShadingPoint points[kRaysPerLane];
  uint tests = 0u;
  if (!findPoints(segments, hits, tests, points)) return false;
  // When a path is traced again, its tests have been added already.
  const bool isNew = !kResumable || (bounce == state.bounce && state.step == 0u);
  if (kCountsTests && isNew) state.tests += tests;
  if (kViewsSurface) {
    [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
      if (isThere(points[r])) state.color[r] = viewedSurface(segments[r].ray, hits[r], points[r].at);
    }
    return true;
  }
  bool isAnyThere = false;
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) isAnyThere = isAnyThere || isThere(points[r]);
  if (!isAnyThere) return true;
  if (!kResumable || bounce == state.bounce) {
    if (!addIllumination(points, settings, state, counts)) return false;
    state.bounce = bounce + 1u;
    state.step = 0u;
  }
  if (!kHasMirrors || bounce == settings[0].maxDepth) return true;
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    segments[r] = reflection(segments[r], points[r]);
    counts.mirror += segments[r].isThere ? 1u : 0u;
    ended = ended && !segments[r].isThere;
  }
  return true;
}

// Traces a packet's paths, of those rays that are there. Returns false where they could not be finished;
// `state` then says what is missing. Without mirrors a path is one segment: the loop's condition is then the
// constant false and compilers remove the loop, which they do not do with a for loop of one iteration.
bool tracePaths(Ray rays[kRaysPerLane], bool isThere[kRaysPerLane], uint entry,
                PathSettings settings[kRaysPerLane], inout PathState state, inout RayCounts counts) {
  Segment segments[kRaysPerLane];
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) segments[r] =
      Segment(rays[r], kNoSurface, entry, isThere[r], vec3(1.0));
  bool finished = false;
  bool ended = false;
  uint bounce = 0u;
  do {
    if (bounce <= settings[0].maxDepth) {  // always true: see traverse
      finished = followSegments(segments, bounce, settings, state, counts, ended);
      ++bounce;
    }
  } while (kHasMirrors && finished && !ended);
  return finished && ended;
}

#endif
