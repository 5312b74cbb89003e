// In which directions a sample looks at a light, which may be a sphere.
#ifndef LIGHT_DIRECTIONS_GLSL
#define LIGHT_DIRECTIONS_GLSL

#include "path_state.glsl"
#include "random.glsl"
#include "shading_point.glsl"

// The directions in which a sample looks at a light.
struct LightDirections {
  PathSettings settings;
  uint use;    // which of the path's sequences they come from
  uint count;  // 1 for a point light
};

// Sets `counts` to the numbers of directions in which to look at a spherical light from the points: one,
// unless the path's colour could exceed 1 with no light blocked. What mirrors may add is a guess: 1 for the
// next point, 1/2 for the earlier ones together. It must not come from the path's state, which differs when
// the path is resumed. Returns false where the device ended the loop.
bool countLightDirections(ShadingPoint points[kRaysPerLane], uint bounce, out uint counts[kRaysPerLane]) {
  vec3 colors[kRaysPerLane];
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    const Material material = points[r].material;
    colors[r] = material.ambient + (kHasMirrors ? material.reflectance : vec3(0.0));
  }
  uint i = 0u;
  for (; i < kLightCount; ++i) {
    const Light light = fetchLight(i);
    [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
      const vec3 toLight = unit(light.position - points[r].at.position);
      colors[r] += phong(points[r].material, light, points[r].at.shadingNormal, toLight, points[r].toViewer);
    }
  }
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    const vec3 color = points[r].weight * colors[r] + (bounce > 0u ? 0.5 : 0.0);
    counts[r] = maxComponent(color) < 0.95 ? 1u : kClampedLightDirections;
  }
  // Not i < kLightCount: compilers take the loop's own condition to be false after the loop.
  return i == kLightCount;
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

#endif
