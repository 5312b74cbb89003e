// The distances that the renderer's own intersection functions return, one shape a ray.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "stress_probes.h"
#include "intersect.glsl"

layout(local_size_x = kWorkGroupSize) in;
layout(std430, set = 0, binding = kBindingProbeIn) readonly buffer Queries { ShapeQuery queries[]; };
layout(std430, set = 0, binding = kBindingProbeOut) buffer Distances { float distances[]; };
layout(push_constant) uniform PushConstants { CountConstants constants; };

float intersectShape(Ray ray, ShapeQuery query) {
  if (query.shape == kShapeSphere) return intersectSphere(ray, query.a, query.b.x);
  if (query.shape == kShapePlane) return intersectPlane(ray, query.a, query.b.x);
  const RayConstants rayConstants = rayConstants(ray);
  if (query.shape == kShapeBox) return intersectBox(ray, rayConstants, query.a, query.b, query.tMax);
  vec3 weights;
  return intersectTriangle(ray, rayConstants, query.a, query.b, query.c, weights);
}

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.count) return;
  const ShapeQuery query = queries[index];
  distances[index] = intersectShape(Ray(query.origin, query.direction), query);
}
