// Renders the pixels of one dispatch, an invocation each.
//
// A pixel that is not finished in one dispatch (it has more lights than one handles, or the device ended the
// loops) keeps what it has in its Pixel and goes on in the next: it traces its camera ray once more, which
// gives the same bits, and adds the lights that are missing, in their order. So the sum is the same whatever
// the dispatches.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "camera.glsl"
#include "shade.glsl"

layout(local_size_x = kWorkGroupSize) in;

layout(constant_id = kSpecCountRays) const bool kCountRays = false;

layout(std430, set = 0, binding = kBindingPixels) buffer Pixels { Pixel pixels[]; };
layout(std430, set = 0, binding = kBindingStatus) buffer Status { DispatchStatus status; };
layout(push_constant) uniform PushConstants { DispatchConstants constants; };

Ray cameraRay(uint pixelIndex) {
  const uvec2 pixel = uvec2(pixelIndex % constants.cropWidth, pixelIndex / constants.cropWidth);
  const vec2 position = (vec2(pixel + uvec2(constants.cropX, constants.cropY)) + 0.5) * constants.pixelSize;
  return Ray(vec3(0.0), cameraDirection(position, constants.halfImage, constants.focalLength));
}

// Adds lights from pixel.nextLight on; that is where it stops where it cannot finish.
void addLights(Ray ray, Hit hit, Material material, inout Pixel pixel, inout uint shadowRays) {
  const SurfacePoint point = surfacePoint(ray, hit);
  const vec3 toViewer = -unit(ray.direction);
  const uint end = min(kLightCount, pixel.nextLight + kMaxLightsPerDispatch);
  for (; pixel.nextLight < end; ++pixel.nextLight) {
    const Light light = lights[pixel.nextLight];
    bool blocked;
    if (!findShadow(point, hit.surface, light.position, constants.rootReference, blocked)) return;
    ++shadowRays;
    if (!blocked) {
      pixel.color += phong(material, light, point.shadingNormal, unit(light.position - point.position), toViewer);
    }
  }
}

// Clamped to [0, 1]; written so that a NaN becomes 0.
float displayed(float c) { return c > 0.0 ? min(c, 1.0) : 0.0; }

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.pixelCount) return;
  const bool resume = constants.resume != 0u;
  Pixel pixel = Pixel(vec3(0.0), 0u);
  if (resume) {
    pixel = pixels[index];
    if (pixel.nextLight == kPixelFinished) return;
  }
  const uint firstLight = pixel.nextLight;

  const Ray ray = cameraRay(constants.firstPixel + index);
  Hit hit = missUpTo(kInfinity);
  const bool found = findHit(false, ray, kNoSurface, constants.rootReference, hit);
  uint shadowRays = 0u;
  if (found && hit.surface != kNoSurface) {
    const Material material = materials[hit.object];
    if (!resume) pixel.color = material.ambient;
    addLights(ray, hit, material, pixel, shadowRays);
  }
  if (kCountRays) atomicAdd(status.shadowRays, shadowRays);

  const bool finished = found && (hit.surface == kNoSurface || pixel.nextLight == kLightCount);
  if (finished) {
    pixel.color = vec3(displayed(pixel.color.r), displayed(pixel.color.g), displayed(pixel.color.b));
    pixel.nextLight = kPixelFinished;
  } else {
    atomicAdd(status.unfinished, 1u);
    if (pixel.nextLight == firstLight) atomicAdd(status.stuck, 1u);
  }
  pixels[index] = pixel;
}
