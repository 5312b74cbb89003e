// What the benchmark's shaders and their host both know; see shaders/interface.h for the rules.
#ifndef LAVARAY_BENCH_BATCH_H
#define LAVARAY_BENCH_BATCH_H

#include "interface.h"

#ifdef __cplusplus
namespace lavaray::gpu {
#endif

// The benchmark's own buffers follow the scene's.
const uint kBindingBatchRays = kSceneBindings;
const uint kBindingBatchResults = kBindingBatchRays + 1u;

// Specialization constants that follow the renderer's.
const uint kSpecBatchMode = kSpecCount;
const uint kSpecBatchCount = kSpecBatchMode + 1u;

const uint kBatchClosest = 0u;  // the first hit, as of camera and mirror rays
const uint kBatchAny = 1u;      // any hit, as of shadow rays
const uint kBatchNoTrace = 2u;  // reads rays and writes results, no more

// A ray o + t d with 0 < t < tMax that does not see the surface `skipped`.
struct BatchRay {
  vec3 origin;
  float tMax;  // below 0: there is no such ray
  vec3 direction;
  uint skipped;
};
const uint kTexelsPerBatchRay = 2u;

struct BatchConstants {
  uint rayCount;
};

#ifdef __cplusplus
}  // namespace lavaray::gpu
#endif
#endif
