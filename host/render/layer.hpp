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

// Numbers about each pixel that go with a picture, for programs that compose pictures. Those of what is seen
// are of the ray through the pixel's centre, whatever the picture's samples: the mean of two depths or two
// objects would be neither's.
enum class Layer {
  kNormal,   // unit normal that is shaded with, on the side that is seen; 0 0 0 where nothing is
  kDepth,    // distance from the camera along the ray, in the scene's units; infinite where nothing is
  kObject,   // number of the object among those of the file that have a material, from 1; 0 where nothing is
  kSamples,  // samples of the picture's pixel
  kError,    // its estimated error, in units of a colour; needs a target error
};

inline constexpr const char* kLayerNames = "normal, depth, object, samples, error";

std::string layerName(Layer layer);
// The layers of names with commas between them. Throws Error(kUsage) that says which name is wrong, and what
// is allowed.
std::vector<Layer> layersNamed(const std::string& names);

std::size_t channelsOf(Layer layer);
// Whether it is of what the pixel's centre sees, so that traceLayer makes it.
bool isTraced(Layer layer);

// Traces the layer of settings.crop. `take` is handed the values pixel by pixel, row by row, in any division;
// `proceed` is called now and then with the share that is done and returns whether to go on. Returns false
// where it was stopped.
bool traceLayer(vulkan::Device& device, const GpuScene& scene, RenderSettings settings, Layer layer,
                const std::function<void(std::span<const float>)>& take,
                const std::function<bool(double)>& proceed);

}  // namespace lavaray
