#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "base/byte_reader.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// Reads a Wavefront OBJ: positions, normals and faces, polygons triangulated by ear clipping, degenerate
// triangles dropped and counted. Everything else in the file (texture coordinates, groups, materials) is
// ignored. What exporters write and other programs load although it is wrong is, too, with a warning.
// Throws UnreadableFile, or Error(kInput) reading `file:line: what is wrong, what is allowed`; in a statement
// of several lines that is the one with the word that is wrong, or its first.
Mesh readObj(const std::filesystem::path& file);

// The same for the text of an OBJ file that need not be there. It is read by all processors in parts of about
// so many bytes, which changes neither the mesh nor the message.
inline constexpr std::size_t kObjPartBytes = 1 << 18;
Mesh parseObj(std::string_view text, const std::filesystem::path& file,
              std::size_t partBytes = kObjPartBytes);

}  // namespace lavaray
