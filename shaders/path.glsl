// One sample of a pixel: what a camera ray and the mirror rays that follow it see.
#ifndef PATH_GLSL
#define PATH_GLSL

#include "light.glsl"
#include "shade.glsl"
#include "view.glsl"

layout(constant_id = kSpecResumable) const bool kResumable = true;

// How far a path has come. It is the same path again whenever it is traced: so one that could not be finished is
// traced from the start, and its colour is added to from here on.
struct PathState {
  vec3 color;
  uint bounce;
  uint step;  // of that bounce: 0 is the ambient colour, i + 1 is light i
  uint rays;  // so far; counted where the view is of them
};

struct RayCounts {
  uint shadow;
  uint mirror;
  uint skippedShadow;
};

struct PathSettings {
  uint maxDepth;  // mirror bounces
  uint index;     // of the sample, and
  uint seed;      // its sequence
};

// Directions in which to look at spherical lights from a point: one, unless what the path shows may exceed 1 with
// all lights unblocked. What mirrors may add is guessed: 1 for the next point, 1/2 for the ones before, which must
// not be taken from the path's state since that is not the same when it is resumed.
uint lightDirections(SurfacePoint point, Material material, vec3 toViewer, vec3 weight, uint bounce) {
  vec3 color = material.ambient + (kHasMirrors ? material.reflectance : vec3(0.0));
  for (uint i = 0u; i < kLightCount; ++i) {
    const Light light = lights[i];
    color += phong(material, light, point.shadingNormal, unit(light.position - point.position), toViewer);
  }
  color = weight * color + (bounce > 0u ? 0.5 : 0.0);
  return maxComponent(color) < 0.95 ? 1u : kClampedLightDirections;
}

// The light's term: the mean over the directions of a spherical light; any value unless `showsAny`. Returns false
// where the device ended the search for shadows.
bool lightTerm(Light light, SurfacePoint point, uint surface, Material material, vec3 toViewer,
               PathSettings settings, uint seed, uint lightDirections, bool showsAny, inout RayCounts counts,
               out vec3 term) {
  const uint directions = light.radius > 0.0 ? lightDirections : 1u;
  term = vec3(0.0);
  bool finished;
  uint i = 0u;
  do {
    const LightSample s = sampleLight(light, point.position, settings.index * directions + i, seed);
    vec3 unblocked = vec3(1.0);
    if (kView != kViewShadow) unblocked = phong(material, light, point.shadingNormal, s.toLight, toViewer);
    bool blocked = false;
    finished = true;
    if (showsAny && maxComponent(unblocked) > 0.0) {
      finished = findShadow(point, surface, s.target, blocked);
      ++counts.shadow;
    } else {
      ++counts.skippedShadow;
    }
    if (!blocked) term += unblocked;
    ++i;
  } while (kHasSphericalLights && finished && i < directions);
  if (kHasSphericalLights) term /= float(directions);
  return finished && (!kHasSphericalLights || i == directions);
}

// Adds what the surface shows by itself, times `weight`, from state.step on. Returns false where the device
// ended the loops or the dispatch has traced its share of shadow rays; state says what is missing.
bool addIllumination(Ray ray, uint surface, SurfacePoint point, Material material, vec3 weight,
                     PathSettings settings, inout PathState state, inout RayCounts counts) {
  if (state.step == 0u) {
    if (kView != kViewShadow) state.color += weight * material.ambient;
    if (kView == kViewCost) ++state.rays;
    state.step = 1u;
  }
  const vec3 toViewer = -unit(ray.direction);
  uint directions = 1u;
  if (kHasSphericalLights) directions = lightDirections(point, material, toViewer, weight, state.bounce);
  for (; state.step <= kLightCount; ++state.step) {
    if (kResumable && counts.shadow >= kMaxShadowRaysPerDispatch) return false;
    const uint i = state.step - 1u;
    const Light light = lights[i];
    const uint use = 1u + state.bounce * kLightCount + i;
    const uint seed = hashCombine(settings.seed, use);
    vec3 term;
    // A sample that is white in all channels stays so: what is added is not negative.
    const bool showsAny = kView == kViewShadow || minComponent(state.color) < 1.0;
    const uint shadowRays = counts.shadow;
    if (!lightTerm(light, point, surface, material, toViewer, settings, seed, directions, showsAny, counts, term)) {
      return false;
    }
    state.color += weight * term;
    if (kView == kViewCost) state.rays += counts.shadow - shadowRays;
  }
  const bool finished = state.step > kLightCount;
  // The lights that are not blocked have been counted so far.
  if (kView == kViewShadow && kLightCount > 0u && finished) state.color /= float(kLightCount);
  return finished;
}

// A path between two of its vertices.
struct Segment {
  Ray ray;
  uint skipped;  // the surface that it leaves
  vec3 weight;   // product of the mirrors' reflectances so far
};

// Finds what the segment hits, adds what that shows and replaces the segment by the mirrored one, or sets `ended`.
// Returns false where it could not be finished; state says what is missing.
bool followSegment(inout Segment segment, uint bounce, PathSettings settings, inout PathState state,
                   inout RayCounts counts, out bool ended) {
  ended = true;
  Hit hit = missUpTo(kInfinity);
  if (!findHit(false, segment.ray, segment.skipped, hit)) return false;
  if (hit.surface == kNoSurface) {
    if (kView == kViewCost) ++state.rays;
    return true;
  }
  const SurfacePoint point = surfacePoint(segment.ray, hit);
  if (kViewsSurface) {
    state.color = viewedSurface(segment.ray, hit, point);
    return true;
  }
  const Material material = materials[hit.object];
  if (!kResumable || bounce == state.bounce) {
    if (!addIllumination(segment.ray, hit.surface, point, material, segment.weight, settings, state, counts)) {
      return false;
    }
    state.bounce = bounce + 1u;
    state.step = 0u;
  }
  if (!kHasMirrors || bounce == settings.maxDepth) return true;
  // Kept finite: an infinite weight times a colour of 0 would be no number.
  segment.weight = min(segment.weight * material.reflectance, vec3(3.4e38));
  if (maxComponent(segment.weight) < kMinReflectance) return true;
  const vec3 incoming = unit(segment.ray.direction);
  const vec3 direction = incoming - 2.0 * dot(incoming, point.shadingNormal) * point.shadingNormal;
  segment.ray = Ray(leave(point, direction), direction);
  segment.skipped = hit.surface;
  ++counts.mirror;
  ended = false;
  return true;
}

// Returns false where the path could not be finished; state says what is missing. Without mirrors a path is one
// segment: the loop's condition is then the constant false, and compilers unwrap it, which they do not do with a
// for loop that turns once.
bool tracePath(Ray ray, PathSettings settings, inout PathState state, inout RayCounts counts) {
  Segment segment = Segment(ray, kNoSurface, vec3(1.0));
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
