// What a lane works on.
//
// Where each pixel has one sample in its centre, that is a block of pixels, a ray for each. Neighbouring
// pixels see much the same, so the lanes that a device runs together take neighbouring blocks, in units of
// kLanesPerUnit lanes. Units are counted row by row, those of the first row of units first.
//
// Elsewhere it is work items (see lane_turns.glsl).
#ifndef LANE_GLSL
#define LANE_GLSL

#include "scene_data.glsl"

const uint kBlockWidth = kRaysPerLane > 1u ? 2u : 1u;
const uint kBlockHeight = kRaysPerLane / kBlockWidth;
const uint kBlocksAcross = kUnitWidth / kBlockWidth;

// The pixel of a lane's ray in an area, of which the first unit's row holds `firstRow`; it may be outside of
// the area.
uvec2 pixelOfRay(uint lane, uint ray, uint areaWidth, uint firstRow) {
  const uint unitsAcross = (areaWidth + kUnitWidth - 1u) / kUnitWidth;
  const uint unit = lane / kLanesPerUnit;
  const uint block = lane % kLanesPerUnit;
  const uint x = unit % unitsAcross * kUnitWidth + block % kBlocksAcross * kBlockWidth;
  const uint y =
      (unit / unitsAcross + firstRow / kRaysPerLane) * kRaysPerLane + block / kBlocksAcross * kBlockHeight;
  return uvec2(x + ray % kBlockWidth, y + ray / kBlockWidth);
}

// Pixels in whose centres the lane takes a sample, one for each ray, or its work items: each has a sum.
struct LaneWork {
  uvec2 pixels[kRaysPerLane];  // of the traced area
  uint items[kRaysPerLane];
  uint first[kRaysPerLane];  // sample
  uint count[kRaysPerLane];  // of samples; 0 where there is no such pixel or item
};

// The pixels of the area from number `firstPixel` on, `count` of them.
void takePixels(uint lane, uint areaWidth, uint firstPixel, uint count, out LaneWork result) {
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    const uvec2 pixel = pixelOfRay(lane, r, areaWidth, firstPixel / areaWidth);
    result.pixels[r] = pixel;
    result.items[r] = pixel.y * areaWidth + pixel.x - firstPixel;  // wraps for one before the first
    result.first[r] = 0u;
    result.count[r] = pixel.x < areaWidth && result.items[r] < count ? 1u : 0u;
  }
}

uint mostSamples(LaneWork lane) {
  uint most = 0u;
  [[unroll]] for (uint i = 0u; i < kRaysPerLane; ++i) most = max(most, lane.count[i]);
  return most;
}

#endif
