#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "base/byte_reader.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// Reads positions, normals and faces of a Wavefront OBJ file. Polygons are triangulated by ear clipping;
// degenerate triangles are dropped and counted. Everything else in the file (texture coordinates, groups,
// materials) is ignored. Invalid data that exporters write and other programs load is accepted, with a
// warning. Throws UnreadableFile, or Error(kInput) of the form `file:line: what is wrong, what is allowed`.
// In a statement of several lines, the line is the one with the wrong word, or else the first.
Mesh readObj(const std::filesystem::path& file);

// The same for the text of an OBJ file that need not exist. All processors read it together, in parts of
// about `partBytes` bytes each; neither the mesh nor any message depends on their size.
inline constexpr std::size_t kObjPartBytes = 1 << 18;
Mesh parseObj(std::string_view text, const std::filesystem::path& file,
              std::size_t partBytes = kObjPartBytes);

}  // namespace lavaray
