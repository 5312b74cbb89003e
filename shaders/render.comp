// Each invocation takes the samples of one work item or, where each pixel has one in its centre, those of a
// block of pixels: one for each of the rays that it traces together.
//
// One dispatch may not finish an item: the item has more shadow rays than a dispatch allows, or the device
// ends the loops. A resumable pipeline then saves the item's state and the next dispatch resumes from it; the
// sum is the same however many dispatches it takes. Most scenes never need that and run a pipeline without
// it, which gives up on such an item and leaves it to a resumable one.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "camera.glsl"
#include "lane_turns.glsl"
#include "path.glsl"
#include "status.glsl"
#include "work_state.glsl"

layout(local_size_x = kWorkGroupSize) in;

layout(std430, set = 0, binding = kBindingWork) readonly buffer Work {
  WorkItem work[];
};
layout(std430, set = 0, binding = kBindingResults) buffer Results {
  WorkResult results[];
};
layout(std430, set = 0, binding = kBindingStates) buffer States {
  WorkState unfinishedItems[];
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

// The packed group at which a packet's camera rays enter the hierarchy: through two pixels at most, or
// through a block of them, which lies in one tile.
uint entryGroup(uvec2 first, uvec2 last) {
  if (!kHasEntryNodes) return kRootGroup;
  const uvec2 tile = first >> constants.tileShift;
  if (tile != last >> constants.tileShift) return kRootGroup;
  return fetchEntryNode(tile.y * constants.tilesAcross + tile.x);
}

void takeWork(uint lane, out LaneWork result) {
  if (kSampling == kSamplingCenter) {
    takePixels(lane, constants.areaWidth, constants.firstPixel, constants.itemCount, result);
    return;
  }
  [[unroll]] for (uint i = 0u; i < kRaysPerLane; ++i) {
    const uint index = lane * kItemsPerLane + i;
    const bool isThere = i < kItemsPerLane && index < constants.itemCount;
    const WorkItem item = work[isThere ? index : 0u];
    result.pixels[i] = uvec2(item.pixel % constants.areaWidth, item.pixel / constants.areaWidth);
    result.items[i] = index;
    result.first[i] = item.first;
    result.count[i] = isThere ? item.count : 0u;
  }
}

// Takes a sample with each ray, where there is one. Returns false where they could not be finished.
bool takeSamples(LaneWork lane, uint turn, inout WorkState states[kRaysPerLane], inout PathState path,
                 inout RayCounts counts) {
  RayWork works[kRaysPerLane];
  Ray rays[kRaysPerLane];
  bool isThere[kRaysPerLane];
  PathSettings settings[kRaysPerLane];
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    const RayWork ofRay = workOfRay(lane, r, turn);
    const uvec2 pixel = ofRay.pixel + uvec2(constants.areaX, constants.areaY);
    // The 0 keeps the samples where they have always been.
    const uint seed = hashCombine(hashCombine(hashCombine(constants.seed, pixel.x), pixel.y), 0u);
    const uint pixelSeed = hashCombine(seed, kUseOfPixel);
    const uint shuffled = shuffledIndex(ofRay.sampled, pixelSeed);
    works[r] = ofRay;
    isThere[r] = ofRay.isThere;
    settings[r] = PathSettings(constants.maxDepth, ofRay.sampled, seed, shuffled);
    rays[r] = sampleRay(pixel, shuffled, pixelSeed);
  }
  const uint entry = entryGroup(works[0].pixel, works[kRaysPerLane - 1u].pixel);
  if (!tracePaths(rays, isThere, entry, settings, path, counts)) return false;
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    vec3 color = path.color[r];
    if (kView == kViewCost) color = vec3(path.tests);
    if (kView != kViewCost && kView != kViewDepth && !kAsData) color = displayed(color);
    [[unroll]] for (uint i = 0u; i < kRaysPerLane; ++i)
        addSample(color, isThere[r] && works[r].sum == i, states[i]);
  }
  clear(path);
  return true;
}

// Takes the samples from the first item's `taken` on. Returns false where it could not take them all. The
// loop has the form of tracePaths's, for the same reasons.
bool takeAllSamples(LaneWork lane, inout WorkState states[kRaysPerLane], inout PathState path,
                    inout RayCounts counts) {
  const uint turns = turnsOf(lane);
  uint turn = states[0].taken;  // where it is not 0, of a single ray
  bool finished = false;
  do {
    if (turn < turns) {  // always true: see traverse
      finished = takeSamples(lane, turn, states, path, counts);
      ++turn;
    }
  } while (kSampling != kSamplingCenter && finished && turn < turns);
  return areTaken(lane, states);
}

void main() {
  LaneWork lane;
  takeWork(gl_GlobalInvocationID.x, lane);
  if (mostSamples(lane) == 0u) return;
  WorkState states[kRaysPerLane];
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) states[r] = newWork();
  PathState path;
  clear(path);
  const uint only = lane.items[0];  // where the pipeline is resumable, with one ray a lane
  if (kResumable) {
    // Read in every mode, needed or not: Mesa 26.1's llvmpipe crashes on a buffer that is first read under a
    // condition.
    const float squares = results[only].squares;
    const WorkState left = unfinishedItems[only];
    if (constants.mode != kModeAll && squares >= 0.0) return;
    if (constants.mode == kModeResumed) states[0] = left;
    restore(states[0], path);
  }
  const WorkState before = states[0];
  RayCounts counts = RayCounts(0u, 0u, 0u, 0u);
  const bool finished = takeAllSamples(lane, states, path, counts);
  tell(counts);
  if (!finished) atomicAdd(status.unfinished, 1u);
  if (kResumable && !finished) {
    save(path, states[0]);
    if (sameProgress(states[0], before)) atomicAdd(status.stuck, 1u);
    unfinishedItems[only] = states[0];
  }
  [[unroll]] for (uint i = 0u; i < kRaysPerLane; ++i) {
    if (lane.count[i] > 0u)
      results[lane.items[i]] = WorkResult(states[i].sum, finished ? states[i].squares : kSquaresUnfinished);
  }
}
