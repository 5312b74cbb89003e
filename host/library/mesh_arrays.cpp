#include "library/mesh_arrays.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/limits.hpp"
#include "base/number_text.hpp"
#include "scene/triangulate.hpp"

namespace lavaray {
namespace {

[[noreturn]] void fail(const std::string& message) {
  throw Error(ExitCode::kInput, "a mesh's " + message);
}

std::vector<glm::dvec3> vectors(const std::string& what, const std::vector<double>& numbers) {
  if (numbers.size() % 3 != 0) {
    fail(what + " are " + std::to_string(numbers.size()) + " numbers, allowed are three for each");
  }
  std::vector<glm::dvec3> result;
  result.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    for (std::size_t k = i; k < i + 3; ++k) {
      if (std::abs(numbers[k]) <= kMaxMagnitude) continue;
      fail(what + " have " + numberText(numbers[k]) + " at " + std::to_string(i / 3) +
           ", allowed are numbers within +-" + numberText(kMaxMagnitude));
    }
    result.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return result;
}

void checkIndices(const std::string& what, const std::vector<std::uint32_t>& indices, std::size_t count) {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] < count) continue;
    fail(what + " have " + std::to_string(indices[i]) + " in triangle " + std::to_string(i / 3) +
         ", allowed are numbers below " + std::to_string(count));
  }
}

void checkLengths(const v0::Mesh& arrays) {
  if (arrays.faces.size() % 3 != 0) {
    fail("faces are " + std::to_string(arrays.faces.size()) +
         " numbers, allowed are three for each triangle");
  }
  if (arrays.corners.empty()) return;
  if (arrays.normals.empty()) fail("corners need normals, of which there are none");
  if (arrays.corners.size() != arrays.faces.size()) {
    fail("corners are " + std::to_string(arrays.corners.size()) +
         " numbers, allowed are as many as its faces' " + std::to_string(arrays.faces.size()));
  }
}

}  // namespace

Mesh meshOf(const v0::Mesh& arrays) {
  checkLengths(arrays);
  Mesh mesh;
  mesh.positions = vectors("vertices", arrays.vertices);
  mesh.normals = vectors("normals", arrays.normals);
  const std::vector<std::uint32_t>& corners = arrays.corners.empty() ? arrays.faces : arrays.corners;
  checkIndices("faces", arrays.faces, mesh.positions.size());
  const bool hasNormals = !mesh.normals.empty();
  if (hasNormals)
    checkIndices(arrays.corners.empty() ? "faces, which number its normals," : "corners", corners,
                 mesh.normals.size());
  mesh.triangles.reserve(arrays.faces.size() / 3);
  for (std::size_t i = 0; i < arrays.faces.size(); i += 3) {
    MeshTriangle triangle{{arrays.faces[i], arrays.faces[i + 1], arrays.faces[i + 2]}};
    if (!hasArea(mesh.positions[triangle.positions[0]], mesh.positions[triangle.positions[1]],
                 mesh.positions[triangle.positions[2]])) {
      ++mesh.degenerateTriangles;
      continue;
    }
    if (hasNormals) triangle.normals = {corners[i], corners[i + 1], corners[i + 2]};
    for (const std::uint32_t normal : triangle.normals) {
      if (hasNormals && mesh.normals[normal] == glm::dvec3(0.0))
        fail("normal " + std::to_string(normal) +
             " is 0 0 0, allowed is any other vector where a face uses it");
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

}  // namespace lavaray
