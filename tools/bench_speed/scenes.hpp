#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace lavaray::bench {

// One mesh, or a cloud of spheres, that fills most of a picture, and two lights.
struct BenchScene {
  std::string name;
  std::string what;  // its origin
  bool isSpheres = false;
  std::size_t primitives = 0;
  Scene scene;
};

// The names of all scenes, in the order in which they are measured; and of those of a quick run.
std::vector<std::string> sceneNames();
std::vector<std::string> quickSceneNames();

// Nothing if the scene's mesh is not in the folder. The image has the given size.
std::optional<BenchScene> makeScene(const std::string& name, const std::filesystem::path& meshFolder,
                                    const ImageSize& size);

}  // namespace lavaray::bench
