// Traces given rays with the renderer's own traversal, or by brute force with its own primitive tests.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "probe.h"
#include "traverse.glsl"

layout(local_size_x = kWorkGroupSize) in;
layout(std430, set = 0, binding = kBindingProbeIn) readonly buffer Rays {
  ProbeRay rays[];
};
layout(std430, set = 0, binding = kBindingProbeOut) buffer Hits {
  ProbeHit hits[];
};
layout(push_constant) uniform PushConstants {
  TraceConstants constants;
};

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.rayCount) return;
  const ProbeRay probe = rays[index];
  const Ray ray = withoutDenormals(Ray(probe.origin, probe.direction));
  Hit hit = missUpTo(probe.tMax);
  uint tests = 0u;
  bool finished;
  if (constants.mode == kTraceClosest) {
    finished = traverse(false, ray, probe.skipped, kRootGroup, hit, tests);
  } else if (constants.mode == kTraceAny) {
    finished = traverse(true, ray, probe.skipped, kRootGroup, hit, tests);
  } else {
    const RayConstants rayConstants = rayConstants(ray);
    uint i = 0u;
    for (; i < constants.primitiveCount; ++i) {
      if (i != probe.skipped) hitPrimitive(ray, rayConstants, i, hit);
    }
    finished = i == constants.primitiveCount;
  }
  const uint order = hit.surface == kNoSurface ? 0xFFFFFFFFu : hit.order;
  hits[index] = ProbeHit(hit.t, order, hit.surface, finished ? 1u : 0u);
}
