#include "library/preparation.hpp"

#include <system_error>

#include "render/preparation.hpp"

namespace lavaray {

Preparation::Preparation(const v0::Device::State& device, const SceneFeatures& scene,
                         const RenderSettings& settings) {
  try {
    thread_ = std::jthread([this, opening = device.opening, scene, tuned = settings]() mutable {
      try {
        OpenDevice& opened = *opening.get();
        if (isDecided_.exchange(true)) return;
        tuned.tuning = opened.tuning.get();
        preparePipeline(opened.device, scene, tuned);
      } catch (...) {
        // Whoever asks for the device or the pipeline learns of it.
      }
    });
  } catch (const std::system_error&) {
    // A limit on threads or memory: the pipeline is made when it is needed.
  }
}

}  // namespace lavaray
