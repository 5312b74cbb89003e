// A buffer from which a gate shader takes a ray and a shape, prepared, without arithmetic of its own.
#include "intersect.glsl"

layout(local_size_x = 1) in;
layout(std430, set = 0, binding = 16) buffer Gate {
  vec3 origin;
  vec3 direction;
  vec3 inverse;
  uvec3 negative;
  vec3 shear;
  uint axis;
  float inverseZ;
  float tMax;
  vec3 a;
  vec3 b;
  vec3 c;
  vec3 weights;
  float distance;
  vec4 near[3];
  vec4 far[3];
  vec4 distances;
};

Ray gateRay() { return Ray(origin, direction); }
RayConstants gateConstants() { return RayConstants(inverse, bvec3(negative), axis, shear, inverseZ); }
