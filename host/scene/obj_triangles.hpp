#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>

#include "scene/obj_part.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// The whole file except its triangles: the mesh has all positions and normals.
struct ObjWhole {
  Mesh mesh;
  bool hasInfinitePositions = false;  // or NaN
  bool hasZeroNormals = false;
};

// What the parts before a given part contain.
struct ObjCounts {
  std::size_t lines = 0;
  std::size_t positions = 0;
  std::size_t normals = 0;
  std::size_t triangles = 0;  // at most
};

// How a face was taken otherwise than the file states it; the user is warned of each.
enum class ObjChange : std::uint8_t { kFaceDropped, kNormalMissing, kNormalZero, kNormalsOnSome };
inline constexpr std::array kObjChanges{ObjChange::kFaceDropped, ObjChange::kNormalMissing,
                                        ObjChange::kNormalZero, ObjChange::kNormalsOnSome};
struct ObjChanges {
  std::size_t faces = 0;
  std::size_t firstLine = 0;
};

struct ObjTriangles {
  std::size_t count = 0;
  std::size_t degenerate = 0;
  std::array<ObjChanges, kObjChanges.size()> changes;  // indexed by ObjChange
  std::exception_ptr error;                            // what ended the work early, if anything did

  [[nodiscard]] ObjChanges& of(ObjChange change) { return changes[static_cast<std::size_t>(change)]; }
  [[nodiscard]] const ObjChanges& of(ObjChange change) const {
    return changes[static_cast<std::size_t>(change)];
  }
};

// The most triangles that the part's faces can have.
std::size_t maxTriangles(const ObjPart& part);

// Splits the part's faces into triangles, which it writes to `out`. Does not throw, because several threads
// call it.
ObjTriangles makeTriangles(const ObjPart& part, const ObjCounts& before, const ObjWhole& whole,
                           std::span<MeshTriangle> out);

// Throws Error(kInput) at the first vertex index that counts back beyond the start of the file.
void checkBackReferences(const ObjPart& part, const ObjCounts& before, const std::filesystem::path& file);

}  // namespace lavaray
