// How far a path has come, what is counted along it, and what distinguishes it from others.
#ifndef PATH_STATE_GLSL
#define PATH_STATE_GLSL

#include "scene_data.glsl"

layout(constant_id = kSpecResumable) const bool kResumable = true;

// How far the paths of a packet have come. Tracing a path again gives the same path, so those that could not
// be finished are traced from the start and add to their colours from this state on.
struct PathState {
  vec3 color[kRaysPerLane];
  uint bounce;
  uint step;   // of the bounce: 0 is the ambient colour, i + 1 is light i
  uint tests;  // so far, see tests.glsl; of all paths
};

void clear(out PathState state) {
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) state.color[r] = vec3(0.0);
  state.bounce = 0u;
  state.step = 0u;
  state.tests = 0u;
}

struct RayCounts {
  uint shadow;
  uint mirror;
  uint skippedShadow;
  uint tests;  // of shadow rays, see tests.glsl
};

// The numbers of a path's sequences: that of the position in the pixel and, from the second constant on, one
// for each light at each bounce.
const uint kUseOfPixel = 0u;
const uint kUseOfFirstLight = 1u;

struct PathSettings {
  uint maxDepth;       // mirror bounces
  uint index;          // the sample's
  uint seed;           // of the sample's sequences
  uint shuffledIndex;  // the sample's in the sequence of positions in the pixel
};

#endif
