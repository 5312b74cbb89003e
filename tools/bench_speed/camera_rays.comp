// Makes the camera rays of a picture in the order in which the renderer's lanes take them: those of a lane
// are side by side, and so are the lanes of a unit. Where a lane's pixel is outside of the picture, there is
// no ray.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "batch.h"
#include "camera.glsl"
#include "hit.glsl"
#include "lane.glsl"

layout(local_size_x = kWorkGroupSize) in;
layout(std430, set = 0, binding = kBindingBatchResults) writeonly buffer Rays {
  BatchRay rays[];
};
layout(push_constant) uniform PushConstants {
  BatchConstants constants;
};

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.rayCount) return;
  const uvec2 pixel = pixelOfRay(index / kRaysPerLane, index % kRaysPerLane, constants.width, 0u);
  const bool isThere = pixel.x < constants.width && pixel.y < constants.height;
  const Ray ray =
      cameraRay((vec2(pixel) + 0.5) * constants.pixelSize, constants.halfImage, constants.focalLength);
  rays[index] = BatchRay(ray.origin, isThere ? kInfinity : kNoRay, ray.direction, kNoSurface);
}
