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

// Numbers for each pixel that go with a picture, for compositing programs. What is seen is seen by the ray
// through the pixel's centre, whatever the picture's samples: the mean of two depths or objects would be
// neither of them.
enum class Layer {
  kNormal,   // the unit normal used for shading, on the side that is seen; 0 0 0 where there is nothing
  kDepth,    // distance from the camera along the ray, in the scene's units; infinite where there is nothing
  kObject,   // number among the file's objects with a material, from 1; 0 where there is nothing
  kSamples,  // samples of the picture's pixel
  kError,    // its estimated error, in units of a colour; needs a target error
};

inline constexpr const char* kLayerNames = "normal, depth, object, samples, error";

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
