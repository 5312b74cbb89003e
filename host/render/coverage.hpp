#pragma once

#include "bvh/gpu_scene.hpp"
#include "render/settings.hpp"

namespace lavaray {

// A rectangle of settings.crop outside of which every pixel is black, since no sample of it can hit anything.
// Empty (x0 == x1 or y0 == y1) if that holds for the whole crop.
Rectangle coverage(const GpuScene& scene, const RenderSettings& settings);

}  // namespace lavaray
