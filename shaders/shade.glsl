// Phong illumination with shadows.
// Based on: Phong, "Illumination for Computer Generated Pictures", 1975.
#ifndef SHADE_GLSL
#define SHADE_GLSL

#include "surface.glsl"

// One minus the cosine of the angle between two unit vectors, computed from their difference: the dot product
// loses the digits that a high power brings out.
float oneMinusCosine(vec3 a, vec3 b) {
  const vec3 difference = a - b;
  return 0.5 * preciseDot(difference, difference);
}

// Zero for a power so small that it may come from denormal numbers: not even the brightest light must show
// these.
float withoutTraces(float power) {
  return power >= kMinExact ? power : 0.0;
}

// cosine^shininess, where 0^0 is 1 and a negative cosine counts as 0. The built-in pow leaves 0^0 undefined,
// and for cosines near 1 its logarithm has too few digits for a high power; there the logarithm is computed
// by the series 2 artanh(x) = ln((1 + x) / (1 - x)).
float specularPower(float oneMinusCosine, float shininess) {
  if (shininess == 0.0) return 1.0;
  if (!(oneMinusCosine < 1.0)) return 0.0;
  if (oneMinusCosine > 0.25) return withoutTraces(pow(1.0 - oneMinusCosine, shininess));
  const float x = oneMinusCosine / (2.0 - oneMinusCosine);
  const float x2 = x * x;
  const float series = x * (1.0 + x2 * (1.0 / 3.0 + x2 * (1.0 / 5.0 + x2 * (1.0 / 7.0))));
  return withoutTraces(exp2(shininess * series * -2.8853901));  // 2 / ln 2
}

// What an unblocked light adds. `toLight` and `toViewer` have unit length, but a light at the point itself
// has no direction: `toLight` is 0, and it adds its ambient term only.
vec3 phong(Material material, Light light, vec3 normal, vec3 toLight, vec3 toViewer) {
  vec3 color = light.ambient * material.ambient;
  const float cosine = preciseDot(toLight, normal);
  if (cosine > 0.0) {
    const vec3 reflected = 2.0 * cosine * normal - toLight;
    color += light.diffuse * material.diffuse * cosine;
    color += light.specular * material.specular *
             specularPower(oneMinusCosine(reflected, toViewer), material.shininess);
  }
  return color;
}

// The largest t at which a surface is in front of the light. A surface through the light does not block it;
// its t would be 1 in exact arithmetic, and is off by the rounding of the numbers that it is computed from,
// at either end.
float shadowRayEnd(vec3 origin, vec3 light, vec3 direction) {
  const float magnitude = maxComponent(abs(origin)) + maxComponent(abs(light));
  return 1.0 - 2.0 * kPositionUlps * kHalfUlp * magnitude / maxComponent(abs(direction));
}

// The ray from the point to a point of the light, which `end` limits. That is not positive where the light
// touches the surface: nothing fits between.
Ray shadowRay(SurfacePoint point, vec3 light, out float end) {
  const vec3 origin = leave(point, light - point.position);
  const Ray ray = Ray(origin, light - origin);
  end = shadowRayEnd(origin, light, ray.direction);
  return ray;
}

#endif
