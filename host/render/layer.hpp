#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bvh/gpu_scene.hpp"
#include "render/settings.hpp"
#include "vulkan/device.hpp"

namespace lavaray {

using v0::kLayerNames;
using v0::Layer;

std::string layerName(Layer layer);
// The layers named in a list separated by commas. Throws Error(kUsage) saying which name is wrong and what is
// allowed.
std::vector<Layer> layersNamed(const std::string& names);

std::size_t channelsOf(Layer layer);
// Whether it shows what the pixel's centre sees, so that traceLayer makes it.
bool isTraced(Layer layer);

// Traces the layer of settings.crop. `take` gets the values pixel by pixel, row by row, in spans of any
// length; `proceed` is called now and then with the share that is done and returns whether to go on. Returns
// false if that stopped it.
bool traceLayer(vulkan::Device& device, const GpuScene& scene, RenderSettings settings, Layer layer,
                const std::function<void(std::span<const float>)>& take,
                const std::function<bool(double)>& proceed);

}  // namespace lavaray
