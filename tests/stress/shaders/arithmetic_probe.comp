// The device's own arithmetic, and the renderer's functions that are closest to it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "shade.glsl"
#include "stress_probes.h"

layout(local_size_x = kWorkGroupSize) in;
layout(std430, set = 0, binding = kBindingProbeIn) readonly buffer Queries {
  ArithmeticQuery queries[];
};
layout(std430, set = 0, binding = kBindingProbeOut) buffer Answers {
  ArithmeticAnswer answers[];
};
layout(push_constant) uniform PushConstants {
  CountConstants constants;
};

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.count) return;
  const float a = queries[index].a;
  const float b = queries[index].b;
  const float c = queries[index].c;
  ArithmeticAnswer answer;
  answer.sum = a + b;
  answer.product = a * b;
  answer.quotient = a / b;
  answer.fused = fma(a, b, c);
  answer.root = sqrt(a);
  answer.inverseRoot = inversesqrt(a);
  answer.power2 = exp2(a);
  answer.minimum = min(a, b);
  answer.maximum = max(a, b);
  answer.isLess = a < b ? 1u : 0u;
  answer.isNotLess = a >= b ? 1u : 0u;
  answer.specular = specularPower(a, b);
  answer.unitVector = unit(vec3(a, b, c));
  answers[index] = answer;
}
