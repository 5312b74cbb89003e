// What a point of a surface shows by itself: its ambient colour and the term of each light, with shadows.
#ifndef ILLUMINATION_GLSL
#define ILLUMINATION_GLSL

#include "light.glsl"
#include "light_directions.glsl"
#include "view.glsl"

// Sets `terms` to the light's terms, each a mean over a point's directions; to any value where not
// `showsAny`. Returns false where the device ended the search for shadows.
bool lightTerms(Light light, ShadingPoint points[kRaysPerLane], LightDirections directions[kRaysPerLane],
                bool showsAny[kRaysPerLane], inout RayCounts counts, out vec3 terms[kRaysPerLane]) {
  uint count = 1u;
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    terms[r] = vec3(0.0);
    if (isThere(points[r])) count = max(count, directions[r].count);
  }
  bool finished = true;
  uint i = 0u;
  do {
    if (i < count) {  // always true: see traverse
      Packet shadows;
      shadows.entry = kRootGroup;
      Hit hits[kRaysPerLane];
      vec3 unblocked[kRaysPerLane];
      [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
        vec2 u = vec2(0.0);
        if (kHasSphericalLights && light.radius > 0.0) u = lightPoint(directions[r], i);
        const LightSample s = sampleLight(light, points[r].at.position, u);
        unblocked[r] = vec3(1.0);
        if (kView != kViewShadow) {
          unblocked[r] =
              phong(points[r].material, light, points[r].at.shadingNormal, s.toLight, points[r].toViewer);
        }
        float end;
        shadows.rays[r] = shadowRay(points[r].at, s.target, end);
        shadows.skipped[r] = points[r].surface;
        const bool looks = isThere(points[r]) && i < directions[r].count;
        const bool traces = looks && showsAny[r] && maxComponent(unblocked[r]) > 0.0;
        hits[r] = missUpTo(traces && end > 0.0 ? end : kNoRay);
        if (!looks) unblocked[r] = vec3(0.0);
        counts.shadow += traces ? 1u : 0u;
        counts.skippedShadow += looks && !traces ? 1u : 0u;
      }
      finished = findHits(true, shadows, hits, counts.tests);
      [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
        if (hits[r].surface == kNoSurface) terms[r] += unblocked[r];
      }
      ++i;
    }
  } while (kHasSphericalLights && finished && i < count);
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    if (kHasSphericalLights) terms[r] /= float(directions[r].count);
  }
  return finished && (!kHasSphericalLights || i == count);
}

// Adds what the points show by themselves, from state.step on. Returns false where the device ended the loops
// or the dispatch has traced its share of shadow rays; `state` then says what is missing.
bool addIllumination(ShadingPoint points[kRaysPerLane], PathSettings settings[kRaysPerLane],
                     inout PathState state, inout RayCounts counts) {
  if (state.step == 0u) {
    [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
      if (kView != kViewShadow && isThere(points[r]))
        state.color[r] += points[r].weight * points[r].material.ambient;
    }
    state.step = 1u;
  }
  uint directionCounts[kRaysPerLane];
  if (kHasSphericalLights && !countLightDirections(points, state.bounce, directionCounts)) return false;
  bool goesOn = true;
  do {
    if (goesOn && state.step <= kLightCount) {  // after the first time always true: see traverse
      const uint i = state.step - 1u;
      const Light light = fetchLight(i);
      const uint use = kUseOfFirstLight + state.bounce * kLightCount + i;
      LightDirections directions[kRaysPerLane];
      bool showsAny[kRaysPerLane];
      [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
        const bool isSphere = kHasSphericalLights && light.radius > 0.0;
        directions[r] = LightDirections(settings[r], use, isSphere ? directionCounts[r] : 1u);
        // A sample that is white in all channels stays white, since no term is negative.
        showsAny[r] = kView == kViewShadow || minComponent(state.color[r]) < 1.0;
      }
      vec3 terms[kRaysPerLane];
      const uint tests = counts.tests;
      goesOn = lightTerms(light, points, directions, showsAny, counts, terms);
      [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
        if (goesOn && isThere(points[r])) state.color[r] += points[r].weight * terms[r];
      }
      if (kCountsTests && goesOn) state.tests += counts.tests - tests;
      if (goesOn) ++state.step;
      if (kResumable && counts.shadow >= kMaxShadowRaysPerDispatch) goesOn = false;
    }
  } while (goesOn && state.step <= kLightCount);
  const bool finished = state.step == kLightCount + 1u;
  // So far the colours are the numbers of lights that are not blocked.
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    if (kView == kViewShadow && kLightCount > 0u && finished) state.color[r] /= float(kLightCount);
  }
  return finished;
}

#endif
