// What the benchmark's shaders and their host share; see shaders/interface.h for the rules.
#ifndef LAVARAY_BENCH_BATCH_H
#define LAVARAY_BENCH_BATCH_H

#include "interface.h"

#ifdef __cplusplus
namespace lavaray::gpu {
#endif

// The benchmark's own buffers come after the scene's.
const uint kBindingBatchRays = kSceneBindings;
const uint kBindingBatchResults = kBindingBatchRays + 1u;

// Specialization constants after the renderer's.
const uint kSpecBatchMode = kSpecCount;
const uint kSpecBatchCount = kSpecBatchMode + 1u;

const uint kBatchClosest = 0u;  // the first hit, as for camera and mirror rays
const uint kBatchAny = 1u;      // any hit, as for shadow rays
const uint kBatchNoTrace = 2u;  // only reads rays and writes results

// A ray o + t d, 0 < t < tMax, that does not see the surface `skipped`.
struct BatchRay {
  vec3 origin;
  float tMax;  // negative where a lane has no ray
  vec3 direction;
  uint skipped;
};
const uint kTexelsPerBatchRay = 2u;

struct BatchConstants {
  uint rayCount;  // those that are not there included
  // Of the picture, for camera rays; see DispatchConstants.
  uint width;
  uint height;
  float focalLength;
  vec2 pixelSize;
  vec2 halfImage;
  uint follower;  // which secondary rays to make: 0 the mirrored ones, 1 + i those to light i
  uint unused;
};

#ifdef __cplusplus
}  // namespace lavaray::gpu
#endif
#endif
