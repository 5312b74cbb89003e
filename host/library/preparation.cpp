#include "library/preparation.hpp"

#include <system_error>

#include "render/preparation.hpp"

namespace lavaray {

Preparation::Preparation(const v0::Device::State& device, const SceneFeatures& scene,
                         const RenderSettings& settings) {
  try {
    thread_ = std::jthread([this, opening = device.opening, scene, settings] {
      try {
        vulkan::Device& opened = opening.get()->device;
        if (!isDecided_.exchange(true)) preparePipeline(opened, scene, settings);
      } catch (...) {
        // Whoever asks for the device or the pipeline learns of it.
      }
    });
  } catch (const std::system_error&) {
    // A limit on threads or memory: the pipeline is made when it is needed.
  }
}

}  // namespace lavaray
