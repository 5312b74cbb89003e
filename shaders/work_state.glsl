// What a work item has summed up so far and, where it is to be resumed, how far its sample under way has
// come.
#ifndef WORK_STATE_GLSL
#define WORK_STATE_GLSL

#include "path_state.glsl"

WorkState newWork() {
  return WorkState(vec3(0.0), 0u, vec3(0.0), 0u, 0u, 0.0, 0u, 0u);
}

void addSample(vec3 color, bool isThere, inout WorkState state) {
  if (!isThere) return;
  state.sum += color;
  state.squares += preciseDot(color, color) / 3.0;
  ++state.taken;
}

// These are for pipelines that can be resumed, in which a lane traces one ray.
void restore(WorkState state, inout PathState path) {
  path.color[0] = state.color;
  path.bounce = state.bounce;
  path.step = state.step;
  path.tests = state.tests;
}
void save(PathState path, inout WorkState state) {
  state.color = path.color[0];
  state.bounce = path.bounce;
  state.step = path.step;
  state.tests = path.tests;
}
bool sameProgress(WorkState a, WorkState b) {
  return a.taken == b.taken && a.bounce == b.bounce && a.step == b.step;
}

#endif
