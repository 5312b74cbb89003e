// For compute shaders of users' own, which run once for each pixel of a picture: which pixel that is, what
// the ray through its centre hits, and where its value goes (docs/shaders.md).
#ifndef PIXEL_GLSL
#define PIXEL_GLSL

#include "camera.glsl"
#include "lane.glsl"
#include "status.glsl"
#include "surface.glsl"

layout(local_size_x = kWorkGroupSize) in;

layout(std430, set = 0, binding = kBindingResults) buffer Results {
  WorkResult results[];
};
layout(push_constant) uniform PushConstants {
  DispatchConstants constants;
};

struct Pixel {
  bool isThere;    // some invocations have none
  uvec2 position;  // in the whole picture, from the top left
  uint item;       // of the dispatch
};

// The invocation's pixel.
Pixel thisPixel() {
  LaneWork lane;
  takePixels(gl_GlobalInvocationID.x, constants.areaWidth, constants.firstPixel, constants.itemCount, lane);
  return Pixel(lane.count[0] > 0u, lane.pixels[0] + uvec2(constants.areaX, constants.areaY), lane.items[0]);
}

// The camera ray through a position in the picture, in pixels; a pixel's centre is position + 0.5.
Ray rayThrough(vec2 position) {
  return cameraRay(position * constants.pixelSize, constants.halfImage, constants.focalLength);
}
Ray rayThrough(Pixel pixel) {
  return rayThrough(vec2(pixel.position) + 0.5);
}

// The nearest surface that the ray hits, other than the one that it leaves (or kNoSurface). If it hits none,
// the hit's surface is kNoSurface. Adds the nodes and primitives that the ray is tested against to `tests`.
Hit nearestHit(Ray ray, uint leaves, inout uint tests) {
  Packet packet;
  packet.rays[0] = ray;
  packet.skipped[0] = leaves;
  packet.entry = kRootGroup;
  Hit hits[kRaysPerLane];
  hits[0] = missUpTo(kInfinity);
  if (!findHits(false, packet, hits, tests)) {
    // The device ended the loops (see kMaxTraversalSteps): the host reports it as an error.
    atomicAdd(status.unfinished, 1u);
    atomicAdd(status.stuck, 1u);
  }
  return hits[0];
}
Hit nearestHit(Ray ray) {
  uint tests = 0u;
  return nearestHit(ray, kNoSurface, tests);
}

bool isHit(Hit hit) {
  return hit.surface != kNoSurface;
}

// What the picture shows in the pixel: any three numbers.
void setPixel(Pixel pixel, vec3 value) {
  results[pixel.item] = WorkResult(value, 0.0);
}

#endif
