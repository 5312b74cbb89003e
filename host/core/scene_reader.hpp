#pragma once

#include <filesystem>
#include <functional>

#include "core/obj_reader.hpp"
#include "core/scene.hpp"

namespace lavaray {

// Reads a mesh file as readObj does, or has it already.
using MeshReader = std::function<Mesh(const std::filesystem::path&)>;

// Reads a scene file and the meshes it names (each OBJ once). Tolerated oddities are in Scene::warnings.
// Throws Error(kInput) reading `file:line: what is wrong, what is allowed`.
Scene readScene(const std::filesystem::path& file, const MeshReader& readMesh = readObj);

}  // namespace lavaray
