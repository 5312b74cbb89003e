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

// Indices of a face's corners are kept as the file has them, since what they name may come later, and how
// much is in the parts before is not known yet: from 1, or below 0 from the end of what precedes the face.
using ObjIndex = std::int32_t;
inline constexpr ObjIndex kObjAbsent = 0;
// An index of a normal that names none in any file: 0, or one beyond all counts.
inline constexpr ObjIndex kObjWrong = std::numeric_limits<ObjIndex>::min();

// Faces of as many corners each, in lines that follow one another.
struct ObjFaces {
  std::uint32_t corners;
  std::uint32_t count;
  std::size_t firstLine;
  // How much of each the part has before them: what indices below 0 count back from.
  std::size_t positionsBefore;
  std::size_t normalsBefore;
};

// From this corner on a face is in this line, which is not the one that it begins in.
struct ObjContinuation {
  std::size_t corner;
  std::size_t line;
};

// Lines of an OBJ file that follow one another. They are counted from 1 in each part.
struct ObjPart {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;  // zero where the file's is not finite
  // Of the faces' corners, one face after the other. No normals at all where no corner has one.
  std::vector<ObjIndex> cornerPositions;
  std::vector<ObjIndex> cornerNormals;
  std::vector<ObjFaces> faces;
  std::vector<ObjContinuation> continuations;  // by corner
  bool hasInfinitePositions = false;           // or NaN
  bool hasZeroNormals = false;
  std::size_t lines = 0;
  std::optional<std::size_t> lineOfNul;  // which ended the part
  std::exception_ptr error;              // which ended it, mostly an ObjProblem

  void clear();  // keeps the vectors' memory
};

// Something wrong in a line of a part.
struct ObjProblem {
  std::size_t line;
  std::string message;
};

// Reads the lines of `text`, which ends with LF, into `part`, which is cleared first. `isFirst` says
// that it is the beginning of the file. Does not throw, as it is called from several threads.
void scanObjPart(std::span<const char> text, bool isFirst, ObjPart& part);

}  // namespace lavaray
