// How a lane's rays share its work.
//
// A ray takes a sample in each turn. Pixels' centres take one turn. Of work items a lane has one or, with
// more rays than the smallest items have samples, as many as have one for each ray then: those are taken at
// once, larger items one after the other, all rays in one pixel.
#ifndef LANE_TURNS_GLSL
#define LANE_TURNS_GLSL

#include "lane.glsl"
#include "random.glsl"

const uint kItemsPerLane = kRaysPerLane > kMinSamplesPerItem ? kRaysPerLane / kMinSamplesPerItem : 1u;
const uint kRaysPerItem = kRaysPerLane / kItemsPerLane;  // of items that are taken at once

// What a ray does in one of the lane's turns.
struct RayWork {
  uvec2 pixel;   // of the traced area
  uint sampled;  // the number of the sample
  uint sum;      // that it belongs to
  bool isThere;
};

bool takesItemsAtOnce(LaneWork lane) {
  return mostSamples(lane) <= kRaysPerItem;
}

// How many turns the lane's work takes. Where it has several items, the rays suffice for any one of them.
uint turnsOf(LaneWork lane) {
  if (kSampling == kSamplingCenter) return 1u;
  if (kItemsPerLane == 1u) return (lane.count[0] + kRaysPerLane - 1u) / kRaysPerLane;
  return takesItemsAtOnce(lane) ? 1u : kItemsPerLane;
}

RayWork workOfRay(LaneWork lane, uint ray, uint turn) {
  if (kSampling == kSamplingCenter) return RayWork(lane.pixels[ray], 0u, ray, lane.count[ray] > 0u);
  if (kItemsPerLane == 1u) {
    const uint taken = turn * kRaysPerLane + ray;
    return RayWork(lane.pixels[0], lane.first[0] + taken, 0u, taken < lane.count[0]);
  }
  RayWork work = RayWork(lane.pixels[0], 0u, 0u, false);
  const bool atOnce = takesItemsAtOnce(lane);
  [[unroll]] for (uint i = 0u; i < kItemsPerLane; ++i) {
    const uint taken = atOnce ? ray % kRaysPerItem : ray;
    if (i == (atOnce ? ray / kRaysPerItem : turn))
      work = RayWork(lane.pixels[i], lane.first[i] + taken, i, taken < lane.count[i]);
  }
  return work;
}

bool areTaken(LaneWork lane, WorkState states[kRaysPerLane]) {
  bool result = true;
  [[unroll]] for (uint i = 0u; i < kRaysPerLane; ++i) result = result && states[i].taken == lane.count[i];
  return result;
}

#endif
