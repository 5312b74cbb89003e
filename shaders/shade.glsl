// Phong illumination with shadows.
// Based on: Phong, "Illumination for Computer Generated Pictures", 1975.
#ifndef SHADE_GLSL
#define SHADE_GLSL

#include "surface.glsl"

// base^shininess for a cosine, with 0^0 = 1. The built-in pow is undefined there.
float specularPower(float cosine, float shininess) {
  if (shininess == 0.0) return 1.0;
  return cosine > 0.0 ? pow(min(cosine, 1.0), shininess) : 0.0;
}

// What an unblocked light adds. `toLight` and `toViewer` have unit length; a light in the point itself has no
// direction (toLight is 0) and adds its ambient term only.
vec3 phong(Material material, Light light, vec3 normal, vec3 toLight, vec3 toViewer) {
  vec3 color = light.ambient * material.ambient;
  const float cosine = dot(toLight, normal);
  if (cosine > 0.0) {
    const vec3 reflected = 2.0 * cosine * normal - toLight;
    color += light.diffuse * material.diffuse * cosine;
    color += light.specular * material.specular * specularPower(dot(reflected, toViewer), material.shininess);
  }
  return color;
}

// Largest t of a shadow ray that counts as before the light. A surface through the light does not block it, and
// its t, 1 in exact arithmetic, is off by the rounding of the numbers it is computed from, at either end.
float shadowRayEnd(vec3 origin, vec3 light, vec3 direction) {
  const float magnitude = maxComponent(abs(origin)) + maxComponent(abs(light));
  return 1.0 - 2.0 * kPositionUlps * kHalfUlp * magnitude / maxComponent(abs(direction));
}

// Sets `blocked` to whether a surface other than `surface` lies between its point and a point of the light.
// Returns false if the device ended the search early.
bool findShadow(SurfacePoint point, uint surface, vec3 light, out bool blocked) {
  blocked = false;
  const vec3 origin = leave(point, light - point.position);
  const Ray ray = Ray(origin, light - origin);
  const float end = shadowRayEnd(origin, light, ray.direction);
  if (!(end > 0.0)) return true;  // the light touches the surface: nothing fits between
  Hit hit = missUpTo(end);
  const bool finished = findHit(true, ray, surface, hit);
  blocked = hit.surface != kNoSurface;
  return finished;
}

#endif
