// What a point of a surface shows by itself: its ambient colour and each light's term, with shadows.
#ifndef ILLUMINATION_GLSL
#define ILLUMINATION_GLSL

#include "light.glsl"
#include "path_state.glsl"
#include "random.glsl"
#include "shade.glsl"
#include "view.glsl"

// Directions in which to look at spherical lights from a point: one, unless what the path shows may exceed 1
// with all lights unblocked. What mirrors may add is guessed: 1 for the next point, 1/2 for the ones before,
// which must not be taken from the path's state since that is not the same when it is resumed. Returns 0
// where the device ended the loop.
uint lightDirections(SurfacePoint point, Material material, vec3 toViewer, vec3 weight, uint bounce) {
  vec3 color = material.ambient + (kHasMirrors ? material.reflectance : vec3(0.0));
  uint i = 0u;
  for (; i < kLightCount; ++i) {
    const Light light = fetchLight(i);
    color += phong(material, light, point.shadingNormal, unit(light.position - point.position), toViewer);
  }
  // Not i < kLightCount: that is the loop's own condition, which compilers take to be false after it.
  if (i != kLightCount) return 0u;
  color = weight * color + (bounce > 0u ? 0.5 : 0.0);
  return maxComponent(color) < 0.95 ? 1u : kClampedLightDirections;
}

// Where direction i of so many goes to the light that is number `use` of the path's sequences. One direction
// for each position in the pixel is stratified together with that, as a narrow shadow depends on both.
vec2 lightPoint(PathSettings settings, uint use, uint directions, uint i) {
  const uint seed = hashCombine(settings.seed, use);
  const uint companion = use - kUseOfFirstLight;
  const bool isCompanion = directions == 1u && companion < kCompanions;
  const uint index = isCompanion ? companionIndex(settings.shuffledIndex, companion)
                                 : shuffledIndex(settings.index * directions + i, seed);
  return pairAt(index, seed);
}

// The light's term: the mean over the directions of a spherical light; any value unless `showsAny`. Returns
// false where the device ended the search for shadows.
bool lightTerm(Light light, SurfacePoint point, uint surface, Material material, vec3 toViewer,
               PathSettings settings, uint use, uint lightDirections, bool showsAny, inout RayCounts counts,
               out vec3 term) {
  const uint directions = light.radius > 0.0 ? lightDirections : 1u;
  term = vec3(0.0);
  bool finished;
  uint i = 0u;
  do {
    vec2 u = vec2(0.0);
    if (kHasSphericalLights && light.radius > 0.0) u = lightPoint(settings, use, directions, i);
    const LightSample s = sampleLight(light, point.position, u);
    vec3 unblocked = vec3(1.0);
    if (kView != kViewShadow) unblocked = phong(material, light, point.shadingNormal, s.toLight, toViewer);
    bool blocked = false;
    finished = true;
    if (showsAny && maxComponent(unblocked) > 0.0) {
      finished = findShadow(point, surface, s.target, blocked, counts.tests);
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
    state.step = 1u;
  }
  const vec3 toViewer = -unit(ray.direction);
  uint directions = 1u;
  if (kHasSphericalLights) directions = lightDirections(point, material, toViewer, weight, state.bounce);
  if (directions == 0u) return false;
  for (; state.step <= kLightCount; ++state.step) {
    if (kResumable && counts.shadow >= kMaxShadowRaysPerDispatch) return false;
    const uint i = state.step - 1u;
    const Light light = fetchLight(i);
    const uint use = kUseOfFirstLight + state.bounce * kLightCount + i;
    vec3 term;
    // A sample that is white in all channels stays so: what is added is not negative.
    const bool showsAny = kView == kViewShadow || minComponent(state.color) < 1.0;
    const uint tests = counts.tests;
    if (!lightTerm(light, point, surface, material, toViewer, settings, use, directions, showsAny, counts,
                   term)) {
      return false;
    }
    state.color += weight * term;
    if (kCountsTests) state.tests += counts.tests - tests;
  }
  const bool finished = state.step > kLightCount;
  // The lights that are not blocked have been counted so far.
  if (kView == kViewShadow && kLightCount > 0u && finished) state.color /= float(kLightCount);
  return finished;
}

#endif
