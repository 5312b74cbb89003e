#pragma once

#include <array>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace lavaray {

// The indices of a face's corners are kept as the file states them: from 1, or negative and counted back from
// the face. What they refer to may come later, and the sizes of the parts before are not known yet.
using ObjIndex = std::int32_t;
inline constexpr ObjIndex kObjAbsent = 0;
// An index of a normal that is valid in no file: 0, or one beyond any count.
inline constexpr ObjIndex kObjWrong = std::numeric_limits<ObjIndex>::min();

// A run of faces with the same number of corners each, on consecutive lines.
struct ObjFaces {
  std::uint32_t corners;
  std::uint32_t count;
  std::size_t firstLine;
  // What the part has before the run: negative indices count back from here.
  std::size_t positionsBefore;
  std::size_t normalsBefore;
};

// From this corner on, a face is on this line instead of the one where it begins.
struct ObjContinuation {
  std::size_t corner;
  std::size_t line;
};

// Consecutive lines of an OBJ file, numbered from 1 in each part.
struct ObjPart {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;  // zero if the file's is not finite
  // Of the faces' corners, face by face. cornerNormals is empty if no corner has a normal.
  std::vector<ObjIndex> cornerPositions;
  std::vector<ObjIndex> cornerNormals;
  std::vector<ObjFaces> faces;
  std::vector<ObjContinuation> continuations;  // sorted by corner
  bool hasInfinitePositions = false;           // or NaN
  bool hasZeroNormals = false;
  std::size_t lines = 0;
  std::optional<std::size_t> lineOfNul;  // the line of a NUL byte, which ended the part
  std::exception_ptr error;              // what ended the part early, usually an ObjProblem

  void clear();  // keeps the vectors' memory
};

// Something that is wrong in a line of a part.
struct ObjProblem {
  std::size_t line;
  std::string message;
};

// Reads the lines of `text`, which must end with LF, into `part`, which it clears first. `isFirst`: the text
// is the start of the file. Does not throw, because several threads call it.
void scanObjPart(std::span<const char> text, bool isFirst, ObjPart& part);

}  // namespace lavaray
