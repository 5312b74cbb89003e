// Each invocation takes the samples of one work item.
//
// One dispatch may not finish an item: the item has more shadow rays than a dispatch allows, or the device
// ends the loops. A resumable pipeline then saves the item's state and the next dispatch resumes from it; the
// sum is the same however many dispatches it takes. Most scenes never need that and run a pipeline without
// it, which gives up on such an item and leaves it to a resumable one.
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

// `index` and `seed` belong to the sequence of positions.
Ray sampleRay(uvec2 pixel, uint index, uint seed) {
  vec2 offset = vec2(0.0);
  if (kSampling != kSamplingCenter) {
    const vec2 u = pairAt(index, seed);
    offset = vec2(filterOffset(u.x, constants.filterSize), filterOffset(u.y, constants.filterSize));
  }
  const vec2 position = (vec2(pixel) + 0.5 + offset) * constants.pixelSize;
  return cameraRay(position, constants.halfImage, constants.focalLength);
}

// Clamps to [0, 1], written so that a NaN becomes 0. So does a number so small that denormal numbers, which
// some devices treat as zero, may have changed it.
float displayed(float c) {
  return c >= kMinExact ? min(c, 1.0) : 0.0;
}
vec3 displayed(vec3 color) {
  return vec3(displayed(color.r), displayed(color.g), displayed(color.b));
}

// The packed group at which the pixel's camera rays enter the hierarchy.
uint entryGroup(uvec2 pixelInArea) {
  if (!kHasEntryNodes) return kRootGroup;
  const uvec2 tile = pixelInArea >> constants.tileShift;
  return fetchEntryNode(tile.y * constants.tilesAcross + tile.x);
}

// Takes the sample that `state` has reached. Returns false where it could not be finished.
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

// Takes the samples from state.taken on. Returns false where it could not take them all. The loop has the
// form of tracePath's, for the same reason.
bool takeSamples(WorkItem item, inout WorkState state, inout RayCounts counts) {
  const uvec2 inArea = uvec2(item.pixel % constants.areaWidth, item.pixel / constants.areaWidth);
  const uvec2 pixel = inArea + uvec2(constants.areaX, constants.areaY);
  const uint entry = entryGroup(inArea);
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

// Without sequences the items are consecutive pixels, so none needs to be read.
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
    // Read in every mode, needed or not: Mesa 26.1's llvmpipe crashes on a buffer that is first read under a
    // condition.
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
