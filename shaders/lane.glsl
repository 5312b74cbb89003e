// What a lane works on.
//
// Where each pixel has one sample in its centre, that is a block of pixels, a ray for each. Neighbouring
// pixels see much the same, so the lanes that a device runs together take neighbouring blocks, in units of
// kLanesPerUnit lanes. Units are counted row by row, those of the first row of units first.
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

struct LaneWork {
  uvec2 pixels[kRaysPerLane];  // of the traced area
  uint items[kRaysPerLane];    // those that the rays belong to
  bool isThere[kRaysPerLane];
  uint first;  // sample
  uint count;  // of samples
};

// The pixels of the area from number `firstPixel` on, `count` of them.
void takePixels(uint lane, uint areaWidth, uint firstPixel, uint count, out LaneWork result) {
  result.first = 0u;
  result.count = 1u;
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    const uvec2 pixel = pixelOfRay(lane, r, areaWidth, firstPixel / areaWidth);
    result.pixels[r] = pixel;
    result.items[r] = pixel.y * areaWidth + pixel.x - firstPixel;  // wraps for one before the first
    result.isThere[r] = pixel.x < areaWidth && result.items[r] < count;
  }
}

// The samples of one work item, which all rays take.
void takeItem(uint lane, uint areaWidth, WorkItem item, bool isThere, out LaneWork result) {
  result.first = item.first;
  result.count = item.count;
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    result.pixels[r] = uvec2(item.pixel % areaWidth, item.pixel / areaWidth);
    result.items[r] = lane;
    result.isThere[r] = isThere;
  }
}

#endif
