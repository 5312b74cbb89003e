#pragma once

#include <atomic>
#include <thread>

#include "bvh/scene_features.hpp"
#include "library/device_state.hpp"
#include "render/settings.hpp"

namespace lavaray {

// A thread that prepares the pipeline of a render as soon as the device is open, unless all that the pipeline
// depends on is known by then.
class Preparation {
 public:
  Preparation(const v0::Device::State& device, const SceneFeatures& scene, const RenderSettings& settings);
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  // It does not begin any more. Returns whether it had begun.
  bool stop() { return isDecided_.exchange(true); }

 private:
  std::atomic<bool> isDecided_ = false;  // by the first of both threads to set it
  std::jthread thread_;
};

}  // namespace lavaray
