// What a point of a surface shows by itself: its ambient colour and the term of each light, with shadows.
#ifndef ILLUMINATION_GLSL
#define ILLUMINATION_GLSL

#include "light.glsl"
#include "path_state.glsl"
#include "random.glsl"
#include "shade.glsl"
#include "view.glsl"

// A point of a surface as a path sees it.
struct ShadingPoint {
  SurfacePoint at;
  uint surface;  // that the point is on; its shadow rays skip it
  Material material;
  vec3 toViewer;  // unit length
  vec3 weight;    // of what the point shows in the path's colour
};

// The directions in which a sample looks at a light.
struct LightDirections {
  PathSettings settings;
  uint use;    // which of the path's sequences they come from
  uint count;  // 1 for a point light
};

// The number of directions in which to look at a spherical light from the point: one, unless the path's
// colour could exceed 1 with no light blocked. What mirrors may add is a guess: 1 for the next point, 1/2 for
// the earlier ones together. It must not come from the path's state, which differs when the path is resumed.
// Returns 0 where the device ended the loop.
uint lightDirectionCount(ShadingPoint point, uint bounce) {
  const Material material = point.material;
  vec3 color = material.ambient + (kHasMirrors ? material.reflectance : vec3(0.0));
  uint i = 0u;
  for (; i < kLightCount; ++i) {
    const Light light = fetchLight(i);
    const vec3 toLight = unit(light.position - point.at.position);
    color += phong(material, light, point.at.shadingNormal, toLight, point.toViewer);
  }
  // Not i < kLightCount: compilers take the loop's own condition to be false after the loop.
  if (i != kLightCount) return 0u;
  color = point.weight * color + (bounce > 0u ? 0.5 : 0.0);
  return maxComponent(color) < 0.95 ? 1u : kClampedLightDirections;
}

// The numbers that choose direction i. With one direction per position in the pixel, the two are stratified
// together, since a narrow shadow depends on both.
vec2 lightPoint(LightDirections directions, uint i) {
  const PathSettings settings = directions.settings;
  const uint seed = hashCombine(settings.seed, directions.use);
  const uint companion = directions.use - kUseOfFirstLight;
  const bool isCompanion = directions.count == 1u && companion < kCompanions;
  const uint index = isCompanion ? companionIndex(settings.shuffledIndex, companion)
                                 : shuffledIndex(settings.index * directions.count + i, seed);
  return pairAt(index, seed);
}

// Sets `term` to the light's term, the mean over the directions; to any value unless `showsAny`. Returns
// false where the device ended the search for shadows.
bool lightTerm(Light light, ShadingPoint point, LightDirections directions, bool showsAny,
               inout RayCounts counts, out vec3 term) {
  term = vec3(0.0);
  bool finished;
  uint i = 0u;
  do {
    vec2 u = vec2(0.0);
    if (kHasSphericalLights && light.radius > 0.0) u = lightPoint(directions, i);
    const LightSample s = sampleLight(light, point.at.position, u);
    vec3 unblocked = vec3(1.0);
    if (kView != kViewShadow) {
      unblocked = phong(point.material, light, point.at.shadingNormal, s.toLight, point.toViewer);
    }
    bool blocked = false;
    finished = true;
    if (showsAny && maxComponent(unblocked) > 0.0) {
      finished = findShadow(point.at, point.surface, s.target, blocked, counts.tests);
      ++counts.shadow;
    } else {
      ++counts.skippedShadow;
    }
    if (!blocked) term += unblocked;
    ++i;
  } while (kHasSphericalLights && finished && i < directions.count);
  if (kHasSphericalLights) term /= float(directions.count);
  return finished && (!kHasSphericalLights || i == directions.count);
}

// Adds what the point shows by itself, from state.step on. Returns false where the device ended the loops or
// the dispatch has traced its share of shadow rays; `state` then says what is missing.
bool addIllumination(ShadingPoint point, PathSettings settings, inout PathState state,
                     inout RayCounts counts) {
  if (state.step == 0u) {
    if (kView != kViewShadow) state.color += point.weight * point.material.ambient;
    state.step = 1u;
  }
  uint directionCount = 1u;
  if (kHasSphericalLights) directionCount = lightDirectionCount(point, state.bounce);
  if (directionCount == 0u) return false;
  for (; state.step <= kLightCount; ++state.step) {
    if (kResumable && counts.shadow >= kMaxShadowRaysPerDispatch) return false;
    const uint i = state.step - 1u;
    const Light light = fetchLight(i);
    const uint use = kUseOfFirstLight + state.bounce * kLightCount + i;
    const LightDirections directions =
        LightDirections(settings, use, light.radius > 0.0 ? directionCount : 1u);
    vec3 term;
    // A sample that is white in all channels stays white, since no term is negative.
    const bool showsAny = kView == kViewShadow || minComponent(state.color) < 1.0;
    const uint tests = counts.tests;
    if (!lightTerm(light, point, directions, showsAny, counts, term)) return false;
    state.color += point.weight * term;
    if (kCountsTests) state.tests += counts.tests - tests;
  }
  const bool finished = state.step > kLightCount;
  // So far the colour is the number of lights that are not blocked.
  if (kView == kViewShadow && kLightCount > 0u && finished) state.color /= float(kLightCount);
  return finished;
}

#endif
