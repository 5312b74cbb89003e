#include "support/obj_peer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

#include <tiny_obj_loader.h>

#include "base/text_lines.hpp"
#include "scene/triangulate.hpp"

namespace lavaray {
namespace {

std::size_t takeDigits(std::string_view& text) {
  const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(count);
  return count;
}

bool take(char c, std::string_view& text) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

// -12 or 0.25
bool isPlainNumber(std::string_view word) {
  take('-', word);
  std::size_t digits = takeDigits(word);
  if (digits == 0) return false;
  if (take('.', word)) {
    const std::size_t decimals = takeDigits(word);
    if (decimals == 0) return false;
    digits += decimals;
  }
  return word.empty() && digits <= 15;
}

bool takePlainIndex(std::string_view& word) {
  take('-', word);
  if (word.starts_with('0')) return false;
  const std::size_t digits = takeDigits(word);
  return digits > 0 && digits <= 9;
}

bool isPlainCorner(std::string_view word) {
  if (!takePlainIndex(word)) return false;
  if (word.empty()) return true;
  if (!take('/', word)) return false;
  if (!word.starts_with('/') && !takePlainIndex(word)) return false;
  return word.empty() || (take('/', word) && takePlainIndex(word) && word.empty());
}

bool isPlainStatement(std::string_view line) {
  const std::string_view keyword = takeWord(line);
  std::vector<std::string_view> words;
  while (true) {
    const std::string_view word = takeWord(line);
    if (word.empty()) break;
    words.push_back(word);
  }
  if (keyword == "f") return words.size() >= 3 && std::ranges::all_of(words, isPlainCorner);
  const bool areNumbers = std::ranges::all_of(words, isPlainNumber);
  if (keyword == "v" || keyword == "vn") return words.size() == 3 && areNumbers;
  if (keyword == "vt") return words.size() == 2 && areNumbers;
  return keyword.empty() || keyword == "o" || keyword == "g" || keyword.starts_with('#');
}

bool isNear(const std::vector<double>& coordinates, const std::vector<glm::dvec3>& vectors) {
  if (coordinates.size() != 3 * vectors.size()) return false;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const double ours = vectors[i / 3][static_cast<int>(i % 3)];
    if (!(std::abs(coordinates[i] - ours) <= 1e-14 * std::abs(ours))) return false;
  }
  return true;
}

// Adds the triangles of a face, with normals where all corners have one that is a direction.
void addFace(std::span<const tinyobj::index_t> corners, const Mesh& mesh, Triangulator& triangulator,
             std::vector<MeshTriangle>& triangles) {
  std::vector<glm::dvec3> polygon;
  bool hasNormals = true;
  for (const tinyobj::index_t& corner : corners) {
    polygon.push_back(mesh.positions.at(static_cast<std::size_t>(corner.vertex_index)));
    const auto normal = static_cast<std::size_t>(corner.normal_index);
    hasNormals = hasNormals && corner.normal_index >= 0 && normal < mesh.normals.size() &&
                 mesh.normals[normal] != glm::dvec3(0.0);
  }
  for (const Triangulator::Corners& t : triangulator.triangulate(polygon)) {
    MeshTriangle triangle{};
    triangle.normals = {kNoNormal, kNoNormal, kNoNormal};
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.positions[i] = static_cast<std::uint32_t>(corners[t[i]].vertex_index);
      if (hasNormals) triangle.normals[i] = static_cast<std::uint32_t>(corners[t[i]].normal_index);
    }
    triangles.push_back(triangle);
  }
}

}  // namespace

bool isPlainObj(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.find_first_of(std::string_view("\r\\\0", 3)) != std::string_view::npos) return false;
    if (!isPlainStatement(line)) return false;
  }
  return true;
}

std::string differenceFromTinyobjloader(const std::string& text, const Mesh& mesh) {
  std::istringstream stream(text);
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning;
  std::string error;
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, nullptr, false))
    return "it refuses it: " + error;
  if (!isNear(attributes.vertices, mesh.positions)) return "other vertices";
  if (!isNear(attributes.normals, mesh.normals)) return "other normals";
  std::vector<MeshTriangle> triangles;
  Triangulator triangulator;
  for (const tinyobj::shape_t& shape : shapes) {
    std::span<const tinyobj::index_t> corners = shape.mesh.indices;
    for (const auto count : shape.mesh.num_face_vertices) {
      addFace(corners.first(count), mesh, triangulator, triangles);
      corners = corners.subspan(count);
    }
  }
  return triangles == mesh.triangles ? "" : "other triangles";
}

}  // namespace lavaray
