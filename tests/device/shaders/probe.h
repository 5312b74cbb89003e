// What the tests' probe shaders and their hosts both know; see shaders/interface.h for the rules.
#ifndef LAVARAY_TEST_PROBE_H
#define LAVARAY_TEST_PROBE_H

#include "interface.h"

#ifdef __cplusplus
namespace lavaray::gpu {
#endif

// A probe's own buffers follow the scene's.
const uint kBindingProbeIn = kSceneBindings;
const uint kBindingProbeOut = kBindingProbeIn + 1u;

struct ProbeRay {
  vec3 origin;
  uint skipped;
  vec3 direction;
  float tMax;
};

struct ProbeHit {
  float t;
  uint order;  // 0xFFFFFFFF for a miss
  uint surface;
  uint finished;  // whether the search came to its end
};

const uint kTraceClosest = 0u;
const uint kTraceAny = 1u;
const uint kTraceBruteForce = 2u;  // the closest, by testing every primitive

struct TraceConstants {
  uint rayCount;
  uint primitiveCount;
  uint mode;
  uint padding0;
};

// Where samples of a light lie.
struct ProbeLightSample {
  vec3 toLight;
  uint padding0;
  vec3 target;
  uint padding1;
};

// Push constants of the light probe: the first `count` samples of the light, as seen from the position.
struct LightConstants {
  Light light;
  vec3 position;
  uint count;
};

#ifdef __cplusplus
}  // namespace lavaray::gpu
#endif
#endif
