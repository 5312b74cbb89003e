#include "scene/obj_part.hpp"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "base/limits.hpp"
#include "base/text_lines.hpp"
#include "base/text_location.hpp"
#include "base/vector_math.hpp"
#include "scene/obj_cursor.hpp"

namespace lavaray {
namespace {

class PartReader {
 public:
  PartReader(std::span<const char> text, ObjPart& part) : cursor_(text), part_(part) {}

  // Returns the number of lines.
  std::size_t read(bool isFirst) {
    if (isFirst) cursor_.skipByteOrderMark();
    for (; !cursor_.isAtEnd(); cursor_.skipLine()) {
      line_ = cursor_.line();
      if (cursor_.takeKeyword("v")) {
        // x y z, then w or a colour or both; only x y z matter here.
        readPosition();
      } else if (cursor_.takeKeyword("f")) {
        readFace();
      } else if (cursor_.takeKeyword("vn")) {
        readNormal();
      } else if (cursor_.takeKeyword("vt")) {
        cursor_.skipWords();
      }
    }
    return cursor_.line() - 1;
  }

 private:
  void readPosition() {
    const glm::dvec3 position = takeVector("v", {3, 4, 6, 7});
    if (!isFinite(position)) part_.hasInfinitePositions = true;
    part_.positions.push_back(position);
  }

  void readNormal() {
    glm::dvec3 normal = takeVector("vn", {3});
    if (!isFinite(normal)) normal = glm::dvec3(0.0);
    if (normal == glm::dvec3(0.0)) part_.hasZeroNormals = true;
    part_.normals.push_back(normal);
  }

  // Returns the first three numbers of the statement.
  glm::dvec3 takeVector(std::string_view keyword, std::initializer_list<std::size_t> allowedCounts) {
    glm::dvec3 result(0.0);
    std::size_t count = 0;
    for (; cursor_.findWord(); ++count) {
      const double number = cursor_.takeNumber();
      if (count < 3) result[static_cast<int>(count)] = number;
    }
    if (std::ranges::find(allowedCounts, count) == allowedCounts.end())
      failCount(keyword, count, allowedCounts);
    return result;
  }

  [[noreturn]] void failCount(std::string_view keyword, std::size_t count,
                              std::initializer_list<std::size_t> allowedCounts) const {
    std::string allowed;
    for (const std::size_t number : allowedCounts) {
      if (!allowed.empty()) allowed += number == *(allowedCounts.end() - 1) ? " or " : ", ";
      allowed += std::to_string(number);
    }
    throw ObjProblem{
        line_, backticked(keyword) + " has " + std::to_string(count) + " numbers, allowed are " + allowed};
  }

  void readFace() {
    std::size_t count = 0;
    for (std::size_t line = line_; cursor_.findWord(); ++count) {
      if (line != cursor_.line()) {
        line = cursor_.line();
        part_.continuations.push_back({part_.cornerPositions.size(), line});
      }
      const ObjCorner corner = cursor_.takeCorner();
      if (count < kMaxFaceCorners) addCorner(corner);
    }
    if (count == 0 || count > kMaxFaceCorners) {
      throw ObjProblem{line_, "a face of " + std::to_string(count) + " corners, allowed are 3 to " +
                                  std::to_string(kMaxFaceCorners)};
    }
    addFace(static_cast<std::uint32_t>(count));
  }

  void addCorner(const ObjCorner& corner) {
    if (corner.normal != kObjAbsent && part_.cornerNormals.empty())
      part_.cornerNormals.resize(part_.cornerPositions.size(), kObjAbsent);
    part_.cornerPositions.push_back(corner.position);
    if (corner.normal != kObjAbsent || !part_.cornerNormals.empty())
      part_.cornerNormals.push_back(corner.normal);
  }

  void addFace(std::uint32_t corners) {
    if (!part_.faces.empty()) {
      ObjFaces& last = part_.faces.back();
      if (last.corners == corners && last.firstLine + last.count == line_ &&
          last.positionsBefore == part_.positions.size() && last.normalsBefore == part_.normals.size()) {
        ++last.count;
        return;
      }
    }
    part_.faces.push_back({corners, 1, line_, part_.positions.size(), part_.normals.size()});
  }

  ObjCursor cursor_;
  ObjPart& part_;
  std::size_t line_ = 0;  // where the statement begins
};

}  // namespace

void ObjPart::clear() {
  positions.clear();
  normals.clear();
  cornerPositions.clear();
  cornerNormals.clear();
  faces.clear();
  continuations.clear();
  hasInfinitePositions = false;
  hasZeroNormals = false;
  lines = 0;
  lineOfNul.reset();
  error = nullptr;
}

void scanObjPart(std::span<const char> text, bool isFirst, ObjPart& part) {
  part.clear();
  const std::string_view content(text.data(), text.size());
  if (const std::size_t nul = content.find('\0'); nul != std::string_view::npos) {
    part.lineOfNul = countLines(content.substr(0, nul + 1));
    return;
  }
  try {
    part.lines = PartReader(text, part).read(isFirst);
  } catch (...) {
    part.error = std::current_exception();
    part.lines = countLines(content);
  }
}

}  // namespace lavaray
