#include "core/obj_reader.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <numeric>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/obj_part.hpp"
#include "core/parallel.hpp"
#include "core/place.hpp"
#include "core/text_file.hpp"
#include "core/triangulate.hpp"

namespace lavaray {
namespace {

// Throws Error(kInput) at the face's line.
[[noreturn]] void failOutOfRange(const Place& place, ObjArray array, long long index, std::size_t count) {
  failAt(place, std::string(kObjArrayNames[array]) + " " + std::to_string(index) +
                    " is out of range, there are " + std::to_string(count));
}

// Parts of about `bytes` each, which end where a line does.
std::vector<std::span<char>> divide(std::string& text, std::size_t bytes) {
  std::vector<std::span<char>> parts;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t lf = text.find('\n', std::min(text.size() - 1, begin + bytes - 1));
    parts.push_back(std::span(text).subspan(begin, lf + 1 - begin));
    begin = lf + 1;
  }
  return parts;
}

std::vector<ObjPart> readParts(const std::vector<std::span<char>>& texts, const std::filesystem::path& file) {
  const unsigned threads = hardwareThreads();
  // A part's lines are counted first, so that the others' messages have their line numbers.
  std::vector<std::size_t> lines(texts.size());
  parallelFor(texts.size(), threads, [&](std::size_t i) {
    lines[i] = countLines({texts[i].data(), texts[i].size()});
  });
  std::exclusive_scan(lines.begin(), lines.end(), lines.begin(), std::size_t{0});
  std::vector<ObjPart> parts(texts.size());
  parallelFor(parts.size(), threads,
              [&](std::size_t i) { parts[i] = readObjPart(texts[i], lines[i], file); });
  return parts;
}

// Makes indices of the part's back references. `counts` is what the parts before it have of each array.
void resolve(ObjPart& part, const std::array<std::size_t, 3>& counts, const std::filesystem::path& file) {
  for (const ObjBackReference& reference : part.backReferences) {
    std::uint32_t& index = part.corners[reference.corner][reference.array];
    const std::size_t count = counts[reference.array] + index;
    const long long resolved = static_cast<long long>(count) + reference.index;
    if (resolved < 0) {
      failOutOfRange({file, part.faces[reference.face].line}, reference.array, reference.index, count);
    }
    index = static_cast<std::uint32_t>(resolved);
  }
}

// The whole file's positions and normals; the parts keep their faces, whose indices are now those of the
// file. Throws what is wrong first in the file, as far as that can be known without looking at what an index
// points at.
std::array<std::size_t, 3> join(std::vector<ObjPart>& parts, const std::filesystem::path& file, Mesh& mesh) {
  std::array<std::size_t, 3> counts{};
  for (ObjPart& part : parts) {
    resolve(part, counts, file);
    if (part.error) std::rethrow_exception(part.error);
    const std::vector<glm::dvec3> positions = std::exchange(part.positions, {});
    const std::vector<glm::dvec3> normals = std::exchange(part.normals, {});
    mesh.positions.insert(mesh.positions.end(), positions.begin(), positions.end());
    mesh.normals.insert(mesh.normals.end(), normals.begin(), normals.end());
    counts = {mesh.positions.size(), counts[kObjTexcoord] + part.texcoords, mesh.normals.size()};
  }
  return counts;
}

struct Triangles {
  std::vector<MeshTriangle> triangles;
  std::size_t degenerate = 0;
  std::exception_ptr error;
};

void addFace(const Mesh& mesh, std::span<const ObjCorner> corners, Triangulator& triangulator,
             std::vector<glm::dvec3>& polygon, Triangles& result) {
  polygon.clear();
  for (const ObjCorner& corner : corners) polygon.push_back(mesh.positions[corner[kObjPosition]]);
  const bool hasNormals =
      std::ranges::none_of(corners, [](const ObjCorner& corner) { return corner[kObjNormal] == kObjAbsent; });
  const auto& triangles = triangulator.triangulate(polygon);
  for (const auto& [a, b, c] : triangles) {
    MeshTriangle triangle{
        .positions = {corners[a][kObjPosition], corners[b][kObjPosition], corners[c][kObjPosition]}};
    if (hasNormals)
      triangle.normals = {corners[a][kObjNormal], corners[b][kObjNormal], corners[c][kObjNormal]};
    result.triangles.push_back(triangle);
  }
  result.degenerate += corners.size() - 2 - triangles.size();
}

Triangles trianglesOf(const ObjPart& part, const Mesh& mesh, const std::array<std::size_t, 3>& counts,
                      const std::filesystem::path& file) {
  Triangles result;
  Triangulator triangulator;
  std::vector<glm::dvec3> polygon;
  result.triangles.reserve(part.faces.size());
  try {
    for (std::size_t i = 0; i < part.faces.size(); ++i) {
      const ObjFace& face = part.faces[i];
      const std::size_t end = i + 1 < part.faces.size() ? part.faces[i + 1].firstCorner : part.corners.size();
      const std::span corners(part.corners.data() + face.firstCorner, end - face.firstCorner);
      for (const ObjCorner& corner : corners) {
        for (const ObjArray array : {kObjPosition, kObjTexcoord, kObjNormal}) {
          if (corner[array] == kObjAbsent || corner[array] < counts[array]) continue;
          failOutOfRange({file, face.line}, array, corner[array] + 1LL, counts[array]);
        }
      }
      addFace(mesh, corners, triangulator, polygon, result);
    }
  } catch (...) {
    result.error = std::current_exception();
  }
  return result;
}

void addTriangles(const std::vector<ObjPart>& parts, const std::array<std::size_t, 3>& counts,
                  const std::filesystem::path& file, Mesh& mesh) {
  std::vector<Triangles> results(parts.size());
  parallelFor(parts.size(), hardwareThreads(),
              [&](std::size_t i) { results[i] = trianglesOf(parts[i], mesh, counts, file); });
  for (const Triangles& result : results) {
    if (result.error) std::rethrow_exception(result.error);
    mesh.triangles.insert(mesh.triangles.end(), result.triangles.begin(), result.triangles.end());
    mesh.degenerateTriangles += result.degenerate;
  }
}

std::string readText(const std::filesystem::path& file) {
  try {
    return readFile(file);
  } catch (const std::system_error& error) {
    throw UnreadableFile(ExitCode::kInput,
                         printable(file.native()) + ": cannot be read: " + error.code().message());
  }
}

}  // namespace

Mesh readObj(const std::filesystem::path& file) {
  return parseObj(readText(file), file);
}

Mesh parseObj(std::string text, const std::filesystem::path& file, std::size_t partBytes) {
  rejectNulBytes(text, file);
  if (!text.empty() && text.back() != '\n') text += '\n';
  std::vector<ObjPart> parts = readParts(divide(text, partBytes), file);
  Mesh mesh;
  mesh.file = file;
  const std::array<std::size_t, 3> counts = join(parts, file, mesh);
  addTriangles(parts, counts, file, mesh);
  if (mesh.triangles.empty()) {
    const std::size_t lastLine = parts.empty() ? 1 : parts.back().lastLine;
    failAt({file, lastLine}, "no face with an area, allowed is a mesh of at least one");
  }
  return mesh;
}

}  // namespace lavaray
