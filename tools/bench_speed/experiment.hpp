#pragma once

#include <functional>

#include "options.hpp"
#include "results.hpp"
#include "scenes.hpp"
#include "vulkan/device.hpp"

namespace lavaray::bench {

using Progress = std::function<void(const std::string&)>;

// Measures everything about one scene.
SceneResult measureScene(vulkan::Device& device, const BenchScene& scene, const Options& options,
                         const Progress& progress);

}  // namespace lavaray::bench
