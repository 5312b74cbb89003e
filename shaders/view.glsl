// What an image shows in place of colours. The view is a specialization constant, so a pipeline has the code
// of one view only.
#ifndef VIEW_GLSL
#define VIEW_GLSL

#include "random.glsl"
#include "surface.glsl"
#include "tests.glsl"

// Whether the view is written as numbers instead of being shown.
layout(constant_id = kSpecAsData) const bool kAsData = false;

// Whether the view is of the surface alone, without lights.
const bool kViewsSurface = kView == kViewNormal || kView == kViewDepth || kView == kViewObject;

// Small enough for a few of them to be added in float32.
const float kFarthest = 1e37;

// One of 2^24 colours, none of them as dark as the background.
vec3 objectColor(uint object) {
  const uint random = hashCombine(0u, object);
  return 0.2 + 0.8 / 255.0 * vec3((uvec3(random) >> uvec3(0u, 8u, 16u)) & 255u);
}

// A depth comes with a 1, so that a sum over samples has their number: samples that hit nothing have no
// depth.
vec3 viewedSurface(Ray ray, Hit hit, SurfacePoint point) {
  if (kView == kViewNormal) return kAsData ? point.shadingNormal : 0.5 * point.shadingNormal + 0.5;
  if (kView == kViewDepth) return vec3(min(hit.t * preciseLength(ray.direction), kFarthest), 1.0, 0.0);
  return kAsData ? vec3(point.object + 1u) : objectColor(point.object);
}

// Clamps to [0, 1], written so that a NaN becomes 0. So does a number so small that denormal numbers, which
// some devices treat as zero, may have changed it.
float displayed(float c) {
  return c >= kMinExact ? min(c, 1.0) : 0.0;
}
vec3 displayed(vec3 color) {
  return vec3(displayed(color.r), displayed(color.g), displayed(color.b));
}

#endif
