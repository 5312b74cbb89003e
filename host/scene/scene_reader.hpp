#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "scene/obj_reader.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// Returns the mesh that readObj would read from the file; may take it from elsewhere.
using MeshReader = std::function<Mesh(const std::filesystem::path&)>;

// Reads a scene file and the meshes that it names, each OBJ file once. What is odd but tolerated is listed in
// Scene::warnings. Throws Error(kInput) of the form `file:line: what is wrong, what is allowed`.
Scene readScene(const std::filesystem::path& file, const MeshReader& readMesh = readObj);

// The same for the text of a scene file that need not exist. Meshes are looked for in the file's folder.
Scene parseScene(std::string_view text, const std::filesystem::path& file,
                 const MeshReader& readMesh = readObj);

}  // namespace lavaray
