// Whether two points that lie on no surface see each other, by the renderer's shadow rays in both directions.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "single_ray.glsl"
#include "stress_probes.h"

layout(local_size_x = kWorkGroupSize) in;
layout(std430, set = 0, binding = kBindingProbeIn) readonly buffer Pairs {
  PointPair pairs[];
};
layout(std430, set = 0, binding = kBindingProbeOut) buffer Answers {
  PairAnswer answers[];
};
layout(push_constant) uniform PushConstants {
  SurfaceConstants constants;
};

// A point in space is taken for a point, known without error, of a surface that is not in the scene.
bool isBlocked(vec3 from, vec3 to) {
  return isInShadow(SurfacePoint(0u, from, 0.0, vec3(0.0), vec3(0.0)), kNoSurface, to);
}

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.count) return;
  const PointPair pair = pairs[index];
  answers[index].blockedFromAToB = isBlocked(pair.a, pair.b) ? 1u : 0u;
  answers[index].blockedFromBToA = isBlocked(pair.b, pair.a) ? 1u : 0u;
}
