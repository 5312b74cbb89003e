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
  const uint first = gl_GlobalInvocationID.x * kRaysPerLane;
  if (first >= constants.rayCount) return;
  Packet packet;
  packet.entry = kRootGroup;
  Hit hits[kRaysPerLane];
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    const int texel = int(min(first + r, constants.rayCount - 1u) * kTexelsPerBatchRay);
    const uvec4 t0 = texelFetch(rayTexels, texel);
    const uvec4 t1 = texelFetch(rayTexels, texel + 1);
    packet.rays[r] = Ray(uintBitsToFloat(t0.xyz), uintBitsToFloat(t1.xyz));
    packet.skipped[r] = t1.w;
    hits[r] = missUpTo(first + r < constants.rayCount ? uintBitsToFloat(t0.w) : kNoRay);
  }
  uint tests = 0u;
  bool finished = true;
  if (kBatchMode != kBatchNoTrace) finished = findHits(kBatchMode == kBatchAny, packet, hits, tests);
  const float nan = uintBitsToFloat(0x7FC00000u);
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    if (first + r >= constants.rayCount) continue;
    float t = !finished ? nan : (hits[r].surface == kNoSurface ? kInfinity : hits[r].t);
    if (kBatchMode == kBatchNoTrace)
      t = preciseDot(packet.rays[r].origin, packet.rays[r].direction) + hits[r].t;
    distances[first + r] = t;
  }
}
