// Takes the samples of one work item an invocation.
//
// An item may not be finished in one dispatch: it has more shadow rays than one allows, or the device ends
// the loops. In a resumable pipeline it leaves its state behind and goes on from there in the next dispatch;
// the sum is the same whatever the dispatches. Most scenes never need that and run a pipeline without it,
// which gives such an item up for a resumable one to do.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "camera.glsl"
#include "path.glsl"

layout(local_size_x = kWorkGroupSize) in;

layout(constant_id = kSpecCountRays) const bool kCountRays = false;

layout(std430, set = 0, binding = kBindingWork) readonly buffer Work {
  WorkItem work[];
};
layout(std430, set = 0, binding = kBindingResults) buffer Results {
  WorkResult results[];
};
layout(std430, set = 0, binding = kBindingStates) buffer States {
  WorkState states[];
};
layout(std430, set = 0, binding = kBindingStatus) buffer Status {
  DispatchStatus status;
};
layout(push_constant) uniform PushConstants {
  DispatchConstants constants;
};

// `index` and `seed` are those of the sequence of positions.
Ray sampleRay(uvec2 pixel, uint index, uint seed) {
  vec2 offset = vec2(0.0);
  if (kSampling != kSamplingCenter) {
    const vec2 u = pairAt(index, seed);
    offset = vec2(filterOffset(u.x, constants.filterSize), filterOffset(u.y, constants.filterSize));
  }
  const vec2 position = (vec2(pixel) + 0.5 + offset) * constants.pixelSize;
  return cameraRay(position, constants.halfImage, constants.focalLength);
}

// Clamped to [0, 1]; written so that a NaN becomes 0. So does what is so small that the denormal numbers,
// which some devices take for zero, have changed it.
float displayed(float c) {
  return c >= kMinExact ? min(c, 1.0) : 0.0;
}
vec3 displayed(vec3 color) {
  return vec3(displayed(color.r), displayed(color.g), displayed(color.b));
}

// The packed group that the pixel's camera rays start with.
uint entryGroup(uvec2 pixelInCrop) {
  if (!kHasEntryNodes) return kRootGroup;
  const uvec2 tile = pixelInCrop >> constants.tileShift;
  return fetchEntryNode(tile.y * constants.tilesAcross + tile.x);
}

// Takes the sample that the state is at. Returns false where it could not be finished.
bool takeSample(uvec2 pixel, uint entry, uint index, uint seed, inout WorkState state,
                inout RayCounts counts) {
  PathState path = PathState(state.color, state.bounce, state.step, state.tests);
  const uint pixelSeed = hashCombine(seed, kUseOfPixel);
  const PathSettings settings =
      PathSettings(constants.maxDepth, index, seed, shuffledIndex(index, pixelSeed));
  const bool finished =
      tracePath(sampleRay(pixel, settings.shuffledIndex, pixelSeed), entry, settings, path, counts);
  if (finished) {
    vec3 color = path.color;
    if (kView == kViewCost) color = vec3(path.tests);
    if (kView != kViewCost && kView != kViewDepth && !kAsData) color = displayed(color);
    state.sum += color;
    state.squares += preciseDot(color, color) / 3.0;
    ++state.taken;
    path = PathState(vec3(0.0), 0u, 0u, 0u);
  }
  state.color = path.color;
  state.bounce = path.bounce;
  state.step = path.step;
  state.tests = path.tests;
  return finished;
}

// Takes samples from state.taken on. Returns false where it could not take them all. The loop is written as
// that of tracePath, for the same reason.
bool takeSamples(WorkItem item, inout WorkState state, inout RayCounts counts) {
  const uvec2 inCrop = uvec2(item.pixel % constants.cropWidth, item.pixel / constants.cropWidth);
  const uvec2 pixel = inCrop + uvec2(constants.cropX, constants.cropY);
  const uint entry = entryGroup(inCrop);
  // The 0 keeps the samples where they have always been.
  const uint seed = hashCombine(hashCombine(hashCombine(constants.seed, pixel.x), pixel.y), 0u);
  bool finished;
  uint i = state.taken;
  do {
    finished = takeSample(pixel, entry, item.first + i, seed, state, counts);
    ++i;
  } while (kSampling != kSamplingCenter && finished && i < item.count);
  return state.taken == item.count;
}

// Without sequences the items are consecutive pixels, which need not be read.
WorkItem workItem(uint index) {
  if (kSampling == kSamplingCenter) return WorkItem(constants.firstPixel + index, 0u, 0u, 1u);
  return work[index];
}

bool sameProgress(WorkState a, WorkState b) {
  return a.taken == b.taken && a.bounce == b.bounce && a.step == b.step;
}

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.itemCount) return;
  WorkState state = WorkState(vec3(0.0), 0u, vec3(0.0), 0u, 0u, 0.0, 0u, 0u);
  if (kResumable) {
    // Both are read whether the mode needs them or not: what Mesa 26.1's llvmpipe makes of a buffer that it
    // first reads under a condition ends in a fault.
    const float squares = results[index].squares;
    const WorkState left = states[index];
    if (constants.mode != kModeAll && squares >= 0.0) return;
    if (constants.mode == kModeResumed) state = left;
  }
  const WorkState before = state;
  RayCounts counts = RayCounts(0u, 0u, 0u, 0u);
  const bool finished = takeSamples(workItem(index), state, counts);
  if (kCountRays) {
    atomicAdd(status.shadowRays, counts.shadow);
    atomicAdd(status.mirrorRays, counts.mirror);
    atomicAdd(status.skippedShadowRays, counts.skippedShadow);
  }
  if (!finished) {
    atomicAdd(status.unfinished, 1u);
    if (kResumable) {
      if (sameProgress(state, before)) atomicAdd(status.stuck, 1u);
      states[index] = state;
    }
  }
  results[index] = WorkResult(state.sum, finished ? state.squares : kSquaresUnfinished);
}
