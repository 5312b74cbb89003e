// How many of a subgroup's lanes are in use while they search the hierarchy. A subgroup makes as many turns
// of a loop as the lane that needs most of them, in all but which the others may do nothing. Only the
// pipeline that counts rays counts turns.
#ifndef LANE_USE_GLSL
#define LANE_USE_GLSL

#extension GL_KHR_shader_subgroup_basic : require

#include "interface.h"

layout(constant_id = kSpecCountRays) const bool kCountRays = false;

// Of this invocation, by kTurns...; its subgroup's lanes are offered to the one that is elected. A global, so
// that the functions on the way here do not hand on what no other pipeline has.
uint turns[kTurnKinds] = uint[kTurnKinds](0u, 0u, 0u, 0u);

void countTurn(const bool anyHit) {
  if (kCountRays) {
    ++turns[anyHit ? kTurnsForAnyHit : kTurnsForNearestHit];
    if (subgroupElect()) turns[anyHit ? kLanesForAnyHit : kLanesForNearestHit] += gl_SubgroupSize;
  }
}

#endif
