// The pinhole camera, at the origin (see GpuScene), looking down -z with +y up.
#ifndef CAMERA_GLSL
#define CAMERA_GLSL

#include "intersect.glsl"
#include "random.glsl"

// Entry i is the inverse of the pixel filter's distribution function at i / (filterSize - 1), in pixels from
// the centre.
layout(std430, set = 0, binding = kBindingFilter) readonly buffer Filter {
  float filterOffsets[];
};

// Maps a uniform number in [0, 1) to an offset from the pixel's centre, distributed as the filter is.
float filterOffset(float u, uint filterSize) {
  if (filterSize == 0u) return u - 0.5;
  const float position = u * float(filterSize - 1u);
  const uint entry = min(uint(position), filterSize - 2u);
  const float fraction = position - float(entry);
  return (1.0 - fraction) * filterOffsets[entry] + fraction * filterOffsets[entry + 1u];
}

// The ray through a position on the image plane, whose top left corner is (0, 0) and bottom right corner
// (2 halfImage.x, 2 halfImage.y), in units of the scene's own pixels. The direction is not normalised, since
// it is exact as it is.
Ray cameraRay(vec2 position, vec2 halfImage, float focalLength) {
  return Ray(vec3(0.0), vec3(position.x - halfImage.x, halfImage.y - position.y, -focalLength));
}

#endif
