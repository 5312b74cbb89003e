// The point of a light at which a shadow ray ends.
#ifndef LIGHT_GLSL
#define LIGHT_GLSL

#include "scene_data.glsl"
#include "vector.glsl"

struct LightSample {
  vec3 toLight;  // unit length; 0 for a point light at the shaded point itself
  vec3 target;   // on the light's surface in that direction, or the point light
};

// Two unit vectors perpendicular to the unit vector z and to each other.
// Based on: Duff et al., "Building an Orthonormal Basis, Revisited", 2017.
void orthonormalBasis(vec3 z, out vec3 x, out vec3 y) {
  const float side = z.z < 0.0 ? -1.0 : 1.0;
  const float a = -1.0 / (side + z.z);
  const float b = z.x * z.y * a;
  x = vec3(1.0 + side * z.x * z.x * a, side * b, -side * z.x);
  y = vec3(b, side + z.y * z.y * a, -z.y);
}

// A direction distributed uniformly over the cone that the light's sphere subtends at the position; over all
// directions if the position is inside. 1 - cos is computed without subtracting nearly equal numbers, so that
// even the narrowest cone keeps its width. Based on: Shirley, Wang and Zimmermann, "Monte Carlo Techniques
// for Direct Lighting Calculations", 1996.
LightSample sampleSphericalLight(Light light, vec3 position, vec2 u) {
  const vec3 axis = light.position - position;
  const float distance = preciseLength(axis);
  const float sineSquared = (light.radius / distance) * (light.radius / distance);
  const bool inside = !(sineSquared < 1.0);
  const float widestOneMinusCosine = inside ? 2.0 : sineSquared / (1.0 + sqrt(1.0 - sineSquared));
  const float oneMinusCosine = u.x * widestOneMinusCosine;
  const float sine = sqrt(oneMinusCosine * (2.0 - oneMinusCosine));
  vec3 x;
  vec3 y;
  const vec3 z = distance > 0.0 ? axis / distance : vec3(0.0, 0.0, 1.0);
  orthonormalBasis(z, x, y);
  // Within +-pi: Vulkan promises nothing about the sine and cosine of larger angles.
  const float angle = 6.2831853 * (u.y < 0.5 ? u.y : u.y - 1.0);
  const vec3 toLight = unit(sine * (cos(angle) * x + sin(angle) * y) + (1.0 - oneMinusCosine) * z);

  const float along = distance * (1.0 - oneMinusCosine);
  const float halfChord = sqrt(max(0.0, light.radius * light.radius - distance * distance * sine * sine));
  return LightSample(toLight, position + (inside ? along + halfChord : along - halfChord) * toLight);
}

// u in [0, 1)^2 chooses the point on a spherical light.
LightSample sampleLight(Light light, vec3 position, vec2 u) {
  if (kHasSphericalLights && light.radius > 0.0) return sampleSphericalLight(light, position, u);
  return LightSample(unit(light.position - position), light.position);
}

#endif
