#pragma once

#include <array>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace lavaray {

// What a corner of a face names, in this order in its arrays.
enum ObjArray : std::uint8_t { kObjPosition, kObjTexcoord, kObjNormal };
inline constexpr std::array<const char*, 3> kObjArrayNames{"vertex", "texture coordinate", "normal"};

// Indices from 0 of what may come later in the file.
using ObjCorner = std::array<std::uint32_t, 3>;
inline constexpr std::uint32_t kObjAbsent = std::numeric_limits<std::uint32_t>::max();

struct ObjFace {
  std::size_t firstCorner;
  std::size_t line;  // of the file, from 1
};

// An index that counts back from what was read before its face. Its corner holds, for now, how many there
// were in the part.
struct ObjBackReference {
  std::size_t face;
  std::size_t corner;
  ObjArray array;
  int index;  // below 0
};

// Lines of an OBJ file that follow one another.
struct ObjPart {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
  std::size_t texcoords = 0;
  std::vector<ObjCorner> corners;
  std::vector<ObjFace> faces;
  std::vector<ObjBackReference> backReferences;
  std::size_t linesBefore = 0;
  std::size_t lastLine = 0;
  std::exception_ptr error;  // which ended it, mostly an Error(kInput)
};

// Reads the lines; `text` ends with LF, and is overwritten. Does not throw, as it is called from several
// threads.
ObjPart readObjPart(std::span<char> text, std::size_t linesBefore, const std::filesystem::path& file);

}  // namespace lavaray
