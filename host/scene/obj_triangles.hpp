#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>

#include "scene/obj_part.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// The whole file, apart from its triangles: the mesh has its positions and normals.
struct ObjWhole {
  Mesh mesh;
  bool hasInfinitePositions = false;  // or NaN
  bool hasZeroNormals = false;
};

// What the parts before a part have.
struct ObjCounts {
  std::size_t lines = 0;
  std::size_t positions = 0;
  std::size_t normals = 0;
  std::size_t triangles = 0;  // at most
};

// What is not as the file says, and people should know of.
enum ObjChange : std::uint8_t { kObjFaceDropped, kObjNormalMissing, kObjNormalZero, kObjNormalsOnSome };
struct ObjChanges {
  std::size_t count = 0;  // of faces
  std::size_t firstLine = 0;
};

struct ObjTriangles {
  std::size_t count = 0;
  std::size_t degenerate = 0;
  std::array<ObjChanges, 4> changes;
  std::exception_ptr error;  // which ended them
};

// How many triangles the part's faces have at most.
std::size_t countTriangles(const ObjPart& part);

// Splits the part's faces into triangles, written to `out`. Does not throw, as it is called from several
// threads.
ObjTriangles makeTriangles(const ObjPart& part, const ObjCounts& before, const ObjWhole& whole,
                           std::span<MeshTriangle> out);

// Throws Error(kInput) at the first vertex that counts back beyond the beginning of the file.
void checkBackReferences(const ObjPart& part, const ObjCounts& before, const std::filesystem::path& file);

}  // namespace lavaray
