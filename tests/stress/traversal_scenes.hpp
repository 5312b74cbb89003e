#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "device/trace_rays.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// Scenes, each with rays that make its traversal hard.

struct SceneAndRays {
  Scene scene;
  std::vector<gpu::ProbeRay> rays;
};

struct TraversalScene {
  const char* name;
  SceneAndRays (*make)(std::size_t rayCount);
};

// All of them, and what one is called in the names of the tests.
std::vector<TraversalScene> traversalScenes();
std::ostream& operator<<(std::ostream& out, const TraversalScene& scene);
std::string traversalSceneName(const testing::TestParamInfo<TraversalScene>& test);

}  // namespace lavaray
