// The pinhole camera: it sits in the origin (see GpuScene) and looks down -z with +y up.
#ifndef CAMERA_GLSL
#define CAMERA_GLSL

#include "intersect.glsl"
#include "random.glsl"

// The inverse of the pixel filter's distribution function at i / (filterSize - 1), in pixels from the centre.
layout(std430, set = 0, binding = kBindingFilter) readonly buffer Filter {
  float filterOffsets[];
};

// Offset from the pixel's centre, distributed as the filter, for a uniform number in [0, 1).
float filterOffset(float u, uint filterSize) {
  if (filterSize == 0u) return u - 0.5;
  const float position = u * float(filterSize - 1u);
  const uint entry = min(uint(position), filterSize - 2u);
  const float fraction = position - float(entry);
  return (1.0 - fraction) * filterOffsets[entry] + fraction * filterOffsets[entry + 1u];
}

// Ray through a position on the image plane: (0, 0) is its top left corner and (2 halfImage.x, 2 halfImage.y)
// its bottom right one, in units of the scene's own pixels. The direction is not normalised because it is
// exact as it is.
Ray cameraRay(vec2 position, vec2 halfImage, float focalLength) {
  return Ray(vec3(0.0), vec3(position.x - halfImage.x, halfImage.y - position.y, -focalLength));
}

#endif
