// Makes the rays that the renderer traces from the points that given rays hit: the mirrored ray and one
// shadow ray per light. They are in the order of the given rays, and those of one ray are side by side.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "batch.h"
#include "shade.glsl"

layout(local_size_x = kWorkGroupSize) in;
layout(set = 0, binding = kBindingBatchRays) uniform utextureBuffer rayTexels;
layout(std430, set = 0, binding = kBindingBatchResults) writeonly buffer Secondary {
  BatchRay secondary[];
};
layout(push_constant) uniform PushConstants {
  BatchConstants constants;
};

const BatchRay kNoRay = BatchRay(vec3(0.0), -1.0, vec3(0.0), kNoSurface);

BatchRay mirrorRay(vec3 incoming, SurfacePoint point, uint surface) {
  const vec3 direction = incoming - 2.0 * preciseDot(incoming, point.shadingNormal) * point.shadingNormal;
  return BatchRay(leave(point, direction), kInfinity, direction, surface);
}

BatchRay shadowRay(vec3 light, SurfacePoint point, uint surface) {
  const vec3 origin = leave(point, light - point.position);
  const vec3 direction = light - origin;
  const float end = shadowRayEnd(origin, light, direction);
  return end > 0.0 ? BatchRay(origin, end, direction, surface) : kNoRay;
}

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.rayCount) return;
  const uvec4 t0 = texelFetch(rayTexels, int(index * kTexelsPerBatchRay));
  const uvec4 t1 = texelFetch(rayTexels, int(index * kTexelsPerBatchRay) + 1);
  const Ray ray = Ray(uintBitsToFloat(t0.xyz), uintBitsToFloat(t1.xyz));
  Hit hit = missUpTo(uintBitsToFloat(t0.w));
  uint tests = 0u;
  const bool finished = findHit(false, ray, t1.w, kRootGroup, hit, tests);
  const bool isHit = finished && hit.surface != kNoSurface;
  const uint first = index * (1u + kLightCount);
  SurfacePoint point;
  if (isHit) point = surfacePoint(ray, hit);
  secondary[first] = kNoRay;
  if (isHit) secondary[first] = mirrorRay(unit(ray.direction), point, hit.surface);
  for (uint i = 0u; i < kLightCount; ++i) {
    secondary[first + 1u + i] = kNoRay;
    if (isHit) secondary[first + 1u + i] = shadowRay(fetchLight(i).position, point, hit.surface);
  }
}
