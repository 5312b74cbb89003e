// How far a path has come, what is counted on the way, and what tells it from others.
#ifndef PATH_STATE_GLSL
#define PATH_STATE_GLSL

#include "interface.h"

layout(constant_id = kSpecResumable) const bool kResumable = true;

// How far a path has come. It is the same path again whenever it is traced: so one that could not be finished
// is traced from the start, and its colour is added to from here on.
struct PathState {
  vec3 color;
  uint bounce;
  uint step;   // of that bounce: 0 is the ambient colour, i + 1 is light i
  uint tests;  // so far, see tests.glsl
};

struct RayCounts {
  uint shadow;
  uint mirror;
  uint skippedShadow;
  uint tests;  // of shadow rays, see tests.glsl
};

// The sequences of a path by number: that of the position in the pixel, and from the other on one for each
// light at each bounce.
const uint kUseOfPixel = 0u;
const uint kUseOfFirstLight = 1u;

struct PathSettings {
  uint maxDepth;       // mirror bounces
  uint index;          // of the sample, and
  uint seed;           // its sequences
  uint shuffledIndex;  // in that of the position in the pixel
};

#endif
