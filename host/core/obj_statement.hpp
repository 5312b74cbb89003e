#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/place.hpp"

namespace lavaray {

// A line of an OBJ file that concerns us; kOther is everything that is ignored.
enum class ObjStatement { kVertex, kTexcoord, kNormal, kFace, kOther };

struct ObjLine {
  ObjStatement statement = ObjStatement::kOther;
  std::array<double, 7> numbers{};  // of a vertex, a texture coordinate or a normal; what is missing is 0
  std::size_t count = 0;            // of these numbers, or of a face's corners
};

// The line without a comment at its end.
std::string_view withoutComment(std::string_view line);

// Reads a line by the letter, since tinyobjloader takes what it does not understand for 0 or for nothing.
// Indices are checked here for their form; whether they exist is not known before the end of the file. Throws
// Error(kInput) at `place`.
ObjLine checkObjLine(std::string_view line, const Place& place);

}  // namespace lavaray
