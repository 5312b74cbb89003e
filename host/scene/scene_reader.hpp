#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "scene/obj_reader.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// Reads a mesh file as readObj does, or has it already.
using MeshReader = std::function<Mesh(const std::filesystem::path&)>;

// Reads a scene file and the meshes it names (each OBJ once). Tolerated oddities are in Scene::warnings.
// Throws Error(kInput) reading `file:line: what is wrong, what is allowed`.
Scene readScene(const std::filesystem::path& file, const MeshReader& readMesh = readObj);

// The same for the text of a scene file that need not be there: meshes are looked for in its folder.
Scene parseScene(std::string_view text, const std::filesystem::path& file,
                 const MeshReader& readMesh = readObj);

}  // namespace lavaray
