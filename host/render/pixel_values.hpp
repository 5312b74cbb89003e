#pragma once

#include <functional>
#include <span>

#include "bvh/gpu_scene.hpp"
#include "interface.h"
#include "render/settings.hpp"
#include "vulkan/device.hpp"

namespace lavaray {

// Takes one sample in the centre of each pixel of settings.crop. `take` gets the results pixel by pixel, row
// by row, in spans of any length; `proceed` is called now and then with the share that is done and returns
// whether to go on. Returns false if that stopped it.
bool tracePixels(vulkan::Device& device, const GpuScene& scene, RenderSettings settings,
                 const std::function<void(std::span<const gpu::WorkResult>)>& take,
                 const std::function<bool(double)>& proceed);

}  // namespace lavaray
