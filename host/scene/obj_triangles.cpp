#include "scene/obj_triangles.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/text_location.hpp"
#include "base/vector_math.hpp"
#include "scene/triangulate.hpp"

namespace lavaray {
namespace {

struct ObjFace {
  const ObjFaces& run;  // the faces that it is one of
  std::size_t firstCorner;
  std::size_t line;  // of the part, where it begins
};

// Calls work(face) for each face of the part.
template <typename Work>
void forEachFace(const ObjPart& part, const Work& work) {
  std::size_t corner = 0;
  for (const ObjFaces& faces : part.faces) {
    for (std::size_t i = 0; i < faces.count; ++i, corner += faces.corners)
      work(ObjFace{faces, corner, faces.firstLine + i});
  }
}

// The index counted from 0; negative if it counts back beyond the start of the file.
long long fromZero(ObjIndex index, std::size_t before) {
  return index > 0 ? index - 1LL : static_cast<long long>(before) + index;
}

std::size_t lineOf(const ObjPart& part, const ObjFace& face, std::size_t corner) {
  const auto after = std::ranges::upper_bound(part.continuations, corner, {}, &ObjContinuation::corner);
  return after == part.continuations.begin() ? face.line : std::max(face.line, (after - 1)->line);
}

[[noreturn]] void failOutOfRange(const TextLocation& location, ObjIndex index, std::size_t count) {
  failAt(location,
         "vertex " + std::to_string(index) + " is out of range, there are " + std::to_string(count));
}

class Splitter {
 public:
  Splitter(const ObjPart& part, const ObjCounts& before, const ObjWhole& whole, std::span<MeshTriangle> out,
           ObjTriangles& result)
      : part_(part), before_(before), whole_(whole), out_(out), result_(result) {}

  void split() {
    forEachFace(part_, [&](const ObjFace& face) {
      readPositions(face);
      if (face.run.corners < 3) {
        note(ObjChange::kFaceDropped, face);
        return;
      }
      const std::optional<ObjChange> change = readNormals(face);
      const std::size_t first = result_.count;
      addTriangles();
      const std::size_t count = result_.count - first;
      result_.degenerate += face.run.corners - 2 - count;
      if (change && count > 0) note(*change, face);
    });
  }

 private:
  void readPositions(const ObjFace& face) {
    const std::size_t before = before_.positions + face.run.positionsBefore;
    positions_.clear();
    polygon_.clear();
    for (std::size_t corner = face.firstCorner; corner < face.firstCorner + face.run.corners; ++corner) {
      const ObjIndex index = part_.cornerPositions[corner];
      const long long position = fromZero(index, before);
      const std::size_t count = whole_.mesh.positions.size();
      if (position < 0 || static_cast<std::size_t>(position) >= count)
        failOutOfRange(locationOf(face, corner), index, index > 0 ? count : before);
      positions_.push_back(static_cast<std::uint32_t>(position));
      polygon_.push_back(whole_.mesh.positions[positions_.back()]);
      if (whole_.hasInfinitePositions && face.run.corners >= 3 && !isFinite(polygon_.back())) {
        failAt(locationOf(face, corner),
               "vertex " + std::to_string(position + 1) +
                   " is not finite, allowed are finite ones where a face uses them");
      }
    }
  }

  // Fills normals_, or leaves it empty if the face is to have its geometric normal. Returns why, unless the
  // file gives the face no normals at all.
  std::optional<ObjChange> readNormals(const ObjFace& face) {
    normals_.clear();
    if (part_.cornerNormals.empty()) return std::nullopt;
    bool isMissing = false;
    bool isZero = false;
    std::size_t absent = 0;
    for (std::size_t corner = face.firstCorner; corner < face.firstCorner + face.run.corners; ++corner) {
      const ObjIndex index = part_.cornerNormals[corner];
      const long long normal = fromZero(index, before_.normals + face.run.normalsBefore);
      if (index == kObjAbsent) {
        ++absent;
      } else if (normal < 0 || static_cast<std::size_t>(normal) >= whole_.mesh.normals.size()) {
        isMissing = true;
      } else {
        normals_.push_back(static_cast<std::uint32_t>(normal));
        isZero = isZero || (whole_.hasZeroNormals && whole_.mesh.normals[normals_.back()] == glm::dvec3(0.0));
      }
    }
    if (normals_.size() == face.run.corners && !isZero) return std::nullopt;
    normals_.clear();
    if (absent == face.run.corners) return std::nullopt;
    return isMissing ? ObjChange::kNormalMissing
                     : (isZero ? ObjChange::kNormalZero : ObjChange::kNormalsOnSome);
  }

  void addTriangles() {
    for (const auto& [a, b, c] : triangulator_.triangulate(polygon_)) {
      MeshTriangle& triangle = out_[result_.count++];
      triangle.positions = {positions_[a], positions_[b], positions_[c]};
      if (!normals_.empty()) triangle.normals = {normals_[a], normals_[b], normals_[c]};
    }
  }

  void note(ObjChange change, const ObjFace& face) {
    ObjChanges& changes = result_.of(change);
    if (changes.faces++ == 0) changes.firstLine = before_.lines + face.line;
  }

  [[nodiscard]] TextLocation locationOf(const ObjFace& face, std::size_t corner) const {
    return {whole_.mesh.file, before_.lines + lineOf(part_, face, corner)};
  }

  const ObjPart& part_;
  const ObjCounts& before_;
  const ObjWhole& whole_;
  std::span<MeshTriangle> out_;
  ObjTriangles& result_;
  Triangulator triangulator_;
  // Of the current face, by corner.
  std::vector<std::uint32_t> positions_;
  std::vector<std::uint32_t> normals_;
  std::vector<glm::dvec3> polygon_;
};

}  // namespace

std::size_t maxTriangles(const ObjPart& part) {
  std::size_t count = 0;
  for (const ObjFaces& faces : part.faces)
    count += std::size_t{faces.count} * (std::max(faces.corners, 2U) - 2U);
  return count;
}

ObjTriangles makeTriangles(const ObjPart& part, const ObjCounts& before, const ObjWhole& whole,
                           std::span<MeshTriangle> out) {
  ObjTriangles result;
  try {
    Splitter(part, before, whole, out, result).split();
  } catch (...) {
    result.error = std::current_exception();
  }
  return result;
}

void checkBackReferences(const ObjPart& part, const ObjCounts& before, const std::filesystem::path& file) {
  forEachFace(part, [&](const ObjFace& face) {
    const std::size_t count = before.positions + face.run.positionsBefore;
    for (std::size_t corner = face.firstCorner; corner < face.firstCorner + face.run.corners; ++corner) {
      const ObjIndex index = part.cornerPositions[corner];
      if (fromZero(index, count) < 0)
        failOutOfRange({file, before.lines + lineOf(part, face, corner)}, index, count);
    }
  });
}

}  // namespace lavaray
