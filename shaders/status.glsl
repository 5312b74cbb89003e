// What a dispatch tells the host.
#ifndef STATUS_GLSL
#define STATUS_GLSL

#include "lane_use.glsl"
#include "path_state.glsl"

layout(std430, set = 0, binding = kBindingStatus) buffer Status {
  DispatchStatus status;
};

void tell(RayCounts counts) {
  if (!kCountRays) return;
  atomicAdd(status.shadowRays, counts.shadow);
  atomicAdd(status.mirrorRays, counts.mirror);
  atomicAdd(status.skippedShadowRays, counts.skippedShadow);
  for (uint i = 0u; i < kTurnKinds; ++i) {
    const uint before = atomicAdd(status.turns[i], turns[i]);
    if (before + turns[i] < before) atomicAdd(status.higherOfTurns[i], 1u);
  }
}

#endif
