// Traces given rays with the renderer's own traversal.
//
// Rays are read through a texel buffer, as the scene is, so that reading them costs little; the mode
// kBatchNoTrace measures how little.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "batch.h"
#include "find_hit.glsl"

layout(local_size_x = kWorkGroupSize) in;
layout(constant_id = kSpecBatchMode) const uint kBatchMode = kBatchClosest;
layout(set = 0, binding = kBindingBatchRays) uniform utextureBuffer rayTexels;
layout(std430, set = 0, binding = kBindingBatchResults) writeonly buffer Distances {
  float distances[];
};
layout(push_constant) uniform PushConstants {
  BatchConstants constants;
};

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.rayCount) return;
  const uvec4 t0 = texelFetch(rayTexels, int(index * kTexelsPerBatchRay));
  const uvec4 t1 = texelFetch(rayTexels, int(index * kTexelsPerBatchRay) + 1);
  const Ray ray = Ray(uintBitsToFloat(t0.xyz), uintBitsToFloat(t1.xyz));
  const float tMax = uintBitsToFloat(t0.w);
  const uint skipped = t1.w;
  if (kBatchMode == kBatchNoTrace) {
    distances[index] = preciseDot(ray.origin, ray.direction) + tMax + float(skipped);
    return;
  }
  Hit hit = missUpTo(tMax);
  uint tests = 0u;
  const bool finished = findHit(kBatchMode == kBatchAny, ray, skipped, kRootGroup, hit, tests);
  const float nan = uintBitsToFloat(0x7FC00000u);
  distances[index] = !finished ? nan : (hit.surface == kNoSurface ? kInfinity : hit.t);
}
