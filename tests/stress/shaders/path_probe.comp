// The colours of the renderer's paths before they are clamped, which would hide a NaN.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "camera.glsl"
#include "path.glsl"
#include "stress_probes.h"

layout(local_size_x = kWorkGroupSize) in;
layout(std430, set = 0, binding = kBindingProbeOut) buffer Colors {
  PathColor colors[];
};
layout(push_constant) uniform PushConstants {
  PathConstants constants;
};

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.width * constants.height) return;
  const vec2 pixel = vec2(index % constants.width, index / constants.width);
  Ray rays[kRaysPerLane];
  rays[0] = cameraRay(pixel + 0.5, 0.5 * vec2(constants.width, constants.height), constants.focalLength);
  bool isThere[kRaysPerLane];
  isThere[0] = true;
  PathState path;
  clear(path);
  RayCounts counts = RayCounts(0u, 0u, 0u, 0u);
  const uint shuffled = shuffledIndex(0u, hashCombine(index, kUseOfPixel));
  PathSettings settings[kRaysPerLane];
  settings[0] = PathSettings(constants.maxDepth, 0u, index, shuffled);
  const bool finished = tracePaths(rays, isThere, kRootGroup, settings, path, counts);
  colors[index] = PathColor(path.color[0], finished ? 1u : 0u);
}
