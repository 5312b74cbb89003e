// Traces given rays with the renderer's own traversal, kRaysPerLane of them together, or by brute force with
// its own primitive tests.
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

bool search(Packet packet, inout Hit found[kRaysPerLane]) {
  uint tests = 0u;
  if (constants.mode != kTraceBruteForce) return traverse(constants.mode == kTraceAny, packet, found, tests);
  uint i = 0u;
  for (; i < constants.primitiveCount; ++i) {
    const Primitive primitive = fetchPrimitive(i);
    [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
      vec3 weights;
      const bool isSphere = kHasSpheres && primitive.kind == kPrimitiveSphere;
      const float t = isSphere ? intersectSphere(packet.rays[r], primitive.a, primitive.b.x)
                               : intersectTriangle(packet.rays[r], primitive, weights);
      if (i != packet.skipped[r]) keepNearer(false, t, i, primitive.order, found[r]);
    }
  }
  return i == constants.primitiveCount;
}

void main() {
  const uint first = gl_GlobalInvocationID.x * kRaysPerLane;
  if (first >= constants.rayCount) return;
  Packet packet;
  packet.entry = kRootGroup;
  Hit found[kRaysPerLane];
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    const ProbeRay probe = rays[min(first + r, constants.rayCount - 1u)];
    packet.rays[r] = withoutDenormals(Ray(probe.origin, probe.direction));
    packet.skipped[r] = probe.skipped;
    found[r] = missUpTo(first + r < constants.rayCount ? probe.tMax : kNoRay);
  }
  const bool finished = search(packet, found);
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    const uint order = found[r].surface == kNoSurface ? 0xFFFFFFFFu : found[r].order;
    if (first + r < constants.rayCount)
      hits[first + r] = ProbeHit(found[r].t, order, found[r].surface, finished ? 1u : 0u);
  }
}
