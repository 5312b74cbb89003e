// One sample of a pixel: what a camera ray, and the mirror rays that continue it, see.
#ifndef PATH_GLSL
#define PATH_GLSL

#include "illumination.glsl"
#include "view.glsl"

// The part of a path between two of its vertices.
struct Segment {
  Ray ray;
  uint skipped;  // the surface that the ray leaves
  uint entry;    // the packed group that the search starts with
  vec3 weight;   // the product of the mirrors' reflectances so far
};

// Finds what the segment hits, adds what that shows and replaces the segment with its reflection, or sets
// `ended`. Returns false where it could not finish; `state` then says what is missing.
bool followSegment(inout Segment segment, uint bounce, PathSettings settings, inout PathState state,
                   inout RayCounts counts, out bool ended) {
  ended = true;
  Hit hit = missUpTo(kInfinity);
  uint tests = 0u;
  if (!findHit(false, segment.ray, segment.skipped, segment.entry, hit, tests)) return false;
  // When a path is traced again, its tests have been added already.
  const bool isNew = !kResumable || (bounce == state.bounce && state.step == 0u);
  if (kCountsTests && isNew) state.tests += tests;
  if (hit.surface == kNoSurface) return true;
  const SurfacePoint point = surfacePoint(segment.ray, hit);
  if (kViewsSurface) {
    state.color = viewedSurface(segment.ray, hit, point);
    return true;
  }
  const Material material = fetchMaterial(hit.object);
  if (!kResumable || bounce == state.bounce) {
    const vec3 toViewer = -unit(segment.ray.direction);
    const ShadingPoint shown = ShadingPoint(point, hit.surface, material, toViewer, segment.weight);
    if (!addIllumination(shown, settings, state, counts)) return false;
    state.bounce = bounce + 1u;
    state.step = 0u;
  }
  if (!kHasMirrors || bounce == settings.maxDepth) return true;
  // Kept finite: an infinite weight times a colour of 0 would be a NaN.
  segment.weight = min(segment.weight * material.reflectance, vec3(3.4e38));
  if (maxComponent(segment.weight) < kMinReflectance) return true;
  const vec3 incoming = unit(segment.ray.direction);
  const vec3 direction = incoming - 2.0 * preciseDot(incoming, point.shadingNormal) * point.shadingNormal;
  segment.ray = Ray(leave(point, direction), direction);
  segment.skipped = hit.surface;
  segment.entry = kRootGroup;
  ++counts.mirror;
  ended = false;
  return true;
}

// Returns false where the path could not be finished; `state` then says what is missing. Without mirrors a
// path is one segment: the loop's condition is then the constant false and compilers remove the loop, which
// they do not do with a for loop of one iteration.
bool tracePath(Ray ray, uint entry, PathSettings settings, inout PathState state, inout RayCounts counts) {
  Segment segment = Segment(ray, kNoSurface, entry, vec3(1.0));
  bool finished = false;
  bool ended = false;
  uint bounce = 0u;
  do {
    finished = followSegment(segment, bounce, settings, state, counts, ended);
    ++bounce;
  } while (kHasMirrors && finished && !ended);
  return finished && ended;
}

#endif
