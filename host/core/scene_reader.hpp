#pragma once

#include <filesystem>

#include "core/scene.hpp"

namespace lavaray {

// Reads a scene file and the meshes it names (each OBJ once). Tolerated oddities are in Scene::warnings.
// Throws Error(kInput) reading `file:line: what is wrong, what is allowed`.
Scene readScene(const std::filesystem::path& file);

}  // namespace lavaray
