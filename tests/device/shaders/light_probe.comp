// Samples a spherical light with the renderer's own function and its own sequences.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "light.glsl"
#include "probe.h"
#include "random.glsl"

layout(local_size_x = kWorkGroupSize) in;
layout(std430, set = 0, binding = kBindingProbeOut) buffer Samples {
  ProbeLightSample samples[];
};
layout(push_constant) uniform PushConstants {
  LightConstants constants;
};

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.count) return;
  const uint seed = hash(1u);
  const LightSample s =
      sampleLight(constants.light, constants.position, pairAt(shuffledIndex(index, seed), seed));
  samples[index] = ProbeLightSample(s.toLight, 0u, s.target, 0u);
}
