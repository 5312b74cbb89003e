// Makes rays that the renderer traces from the points that given rays hit: the mirrored rays, or the shadow
// rays to one light. Each is in its given ray's place, so that lanes trace together what they trace together
// in the renderer.
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

const BatchRay kNothing = BatchRay(vec3(0.0), kNoRay, vec3(0.0), kNoSurface);

BatchRay mirrorRay(vec3 incoming, SurfacePoint point, uint surface) {
  const vec3 direction = incoming - 2.0 * preciseDot(incoming, point.shadingNormal) * point.shadingNormal;
  return BatchRay(leave(point, direction), kInfinity, direction, surface);
}

BatchRay shadowRay(vec3 light, SurfacePoint point, uint surface) {
  float end;
  const Ray ray = shadowRay(point, light, end);
  return end > 0.0 ? BatchRay(ray.origin, end, ray.direction, surface) : kNothing;
}

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.rayCount) return;
  const uvec4 t0 = texelFetch(rayTexels, int(index * kTexelsPerBatchRay));
  const uvec4 t1 = texelFetch(rayTexels, int(index * kTexelsPerBatchRay) + 1);
  const Ray ray = Ray(uintBitsToFloat(t0.xyz), uintBitsToFloat(t1.xyz));
  Packet packet;
  packet.entry = kRootGroup;
  packet.rays[0] = ray;
  packet.skipped[0] = t1.w;
  Hit hits[kRaysPerLane];
  hits[0] = missUpTo(uintBitsToFloat(t0.w));
  uint tests = 0u;
  const bool finished = findHits(false, packet, hits, tests);
  const Hit hit = hits[0];
  const bool isHit = finished && hit.surface != kNoSurface;
  SurfacePoint point;
  if (isHit) point = surfacePoint(ray, hit);
  secondary[index] = kNothing;
  if (!isHit) return;
  if (constants.follower == 0u) {
    secondary[index] = mirrorRay(unit(ray.direction), point, hit.surface);
  } else {
    secondary[index] = shadowRay(fetchLight(constants.follower - 1u).position, point, hit.surface);
  }
}
