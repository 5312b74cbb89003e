// The distances that the renderer's own intersection functions return, one shape per ray.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "hit.glsl"
#include "node.glsl"
#include "stress_probes.h"

layout(local_size_x = kWorkGroupSize) in;
layout(std430, set = 0, binding = kBindingProbeIn) readonly buffer Queries {
  ShapeQuery queries[];
};
layout(std430, set = 0, binding = kBindingProbeOut) buffer Distances {
  float distances[];
};
layout(push_constant) uniform PushConstants {
  CountConstants constants;
};

// The box four times, as a node holds it, for the nearest hit and for any.
float intersectBox(Ray ray, vec3 lower, vec3 upper, float tMax) {
  Ray rays[kRaysPerLane];
  rays[0] = ray;
  bool isIn[kRaysPerLane];
  isIn[0] = true;
  const Approach nearest = approachOf(false, rays, isIn, ray);
  const Approach any = approachOf(true, rays, isIn, ray);
  vec4 near[3];
  vec4 far[3];
  for (int axis = 0; axis < 3; ++axis) {
    near[axis] = vec4(nearest.negative[axis] ? upper[axis] : lower[axis]);
    far[axis] = vec4(nearest.negative[axis] ? lower[axis] : upper[axis]);
  }
  vec4 entry;
  vec4 anyEntry;
  const bvec4 enters = entersBoxes(nearest.beams[0], near, far, tMax, entry);
  const bvec4 anyEnters = entersBoxes(any.beams[0], near, far, tMax, anyEntry);
  const bool agree = enters == enters.yzwx && entry == entry.yzwx && enters == anyEnters && entry == anyEntry;
  return agree ? (enters.x ? entry.x : kInfinity) : -1.0;  // -1, which is no distance
}

float intersectShape(Ray ray, ShapeQuery query) {
  if (query.shape == kShapeSphere) return intersectSphere(ray, query.a, query.b.x);
  if (query.shape == kShapePlane) return intersectPlane(ray, query.a, query.b.x);
  if (query.shape == kShapeBox) return intersectBox(ray, query.a, query.b, query.tMax);
  vec3 weights;
  return intersectTriangle(ray, Primitive(query.a, 0u, query.b, 0u, query.c, 0u), weights);
}

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.count) return;
  const ShapeQuery query = queries[index];
  distances[index] = intersectShape(withoutDenormals(Ray(query.origin, query.direction)), query);
}
