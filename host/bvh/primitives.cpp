#include "bvh/primitives.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/errors.hpp"
#include "base/text_location.hpp"
#include "base/vector_math.hpp"

namespace lavaray {
namespace {

// The object of an array's element, or one after every object.
template <typename Element>
std::uint32_t objectAt(const std::vector<Element>& elements, std::size_t index) {
  return index < elements.size() ? elements[index].object : std::numeric_limits<std::uint32_t>::max();
}

// The index of the first element from `index` on whose object is not below the given one.
template <typename Element>
std::size_t skipBelow(const std::vector<Element>& elements, std::size_t index, std::uint32_t object) {
  while (index < elements.size() && elements[index].object < object) ++index;
  return index;
}

// Equal for shapes that coincide: a triangle's vertices in any order, or a sphere's centre and radius, as
// bits.
using ShapeKey = std::array<std::uint32_t, 10>;

ShapeKey keyOf(const gpu::Primitive& shape) {
  std::array<glm::vec3, 3> corners{shape.a, shape.b, shape.c};
  if (shape.kind != gpu::kPrimitiveSphere) {
    std::sort(corners.begin(), corners.end(), [](const glm::vec3& a, const glm::vec3& b) {
      return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
    });
  }
  ShapeKey key{shape.kind == gpu::kPrimitiveSphere ? 1U : 0U};
  for (int i = 0; i < 9; ++i) {
    key[1 + i] = std::bit_cast<std::uint32_t>(corners[i / 3][i % 3] + 0.0F);  // turns -0 into 0
  }
  return key;
}

struct ShapeKeyHash {
  std::size_t operator()(const ShapeKey& key) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t word : key) {
      hash = (hash ^ word) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

}  // namespace

// Each of the scene's arrays is sorted by object, so this merges them.
Primitives::Primitives(const Scene& scene) : scene_(scene), frame_(frameOf(scene)) {
  const std::size_t count = primitiveCount(scene);
  if (count > gpu::kMaxReference) {
    throw Error(ExitCode::kInput, printable(scene.file.native()) + ": " + std::to_string(count) +
                                      " spheres and triangles; at most " +
                                      std::to_string(gpu::kMaxReference) + " are allowed");
  }
  std::size_t sphere = 0;
  std::size_t triangle = 0;
  std::size_t mesh = 0;
  while (size_ < count) {
    const std::uint32_t nextSphere = objectAt(scene.spheres, sphere);
    const std::uint32_t nextTriangle = objectAt(scene.triangles, triangle);
    const std::uint32_t nextMesh = objectAt(scene.meshObjects, mesh);
    if (nextSphere < std::min(nextTriangle, nextMesh)) {
      const std::size_t end = skipBelow(scene.spheres, sphere + 1, std::min(nextTriangle, nextMesh));
      addRun(Source::kSpheres, sphere, end - sphere, nullptr);
      sphere = end;
    } else if (nextTriangle < nextMesh) {
      const std::size_t end = skipBelow(scene.triangles, triangle + 1, std::min(nextSphere, nextMesh));
      addRun(Source::kTriangles, triangle, end - triangle, nullptr);
      triangle = end;
    } else {
      const MeshObject& object = scene.meshObjects[mesh++];
      addRun(Source::kMesh, 0, scene.meshes[object.mesh].triangles.size(), &object);
    }
  }
}

void Primitives::addRun(Source source, std::size_t begin, std::size_t count, const MeshObject* mesh) {
  if (count == 0) return;
  runs_.push_back({size_, source, begin, mesh != nullptr ? &scene_.meshes[mesh->mesh] : nullptr,
                   mesh != nullptr ? mesh->object : 0});
  size_ += static_cast<std::uint32_t>(count);
}

bool Primitives::hasCornerNormals() const {
  return std::ranges::any_of(
      runs_, [](const Run& run) { return run.mesh != nullptr && !run.mesh->normals.empty(); });
}

const Primitives::Run& Primitives::runOf(std::uint32_t index) const {
  const auto after = std::upper_bound(runs_.begin(), runs_.end(), index,
                                      [](std::uint32_t i, const Run& run) { return i < run.first; });
  return *(after - 1);
}

std::array<glm::dvec3, 3> Primitives::vertices(const Run& run, std::uint32_t index) const {
  const std::size_t i = run.begin + (index - run.first);
  if (run.source == Source::kTriangles) return scene_.triangles[i].vertices;
  const auto [a, b, c] = run.mesh->triangles[i].positions;
  return {run.mesh->positions[a], run.mesh->positions[b], run.mesh->positions[c]};
}

gpu::Primitive Primitives::sphere(const Run& run, std::uint32_t index) const {
  const Sphere& sphere = scene_.spheres[run.begin + (index - run.first)];
  const glm::vec3 radius(frame_.length(sphere.radius), 0.0F, 0.0F);
  return {
      frame_.position(sphere.center), gpu::kPrimitiveSphere, radius, sphere.object, glm::vec3(0.0F), index};
}

gpu::Primitive Primitives::triangle(const Run& run, std::uint32_t index,
                                    const std::array<glm::dvec3, 3>& v) const {
  const std::uint32_t object =
      run.mesh != nullptr ? run.object : scene_.triangles[run.begin + (index - run.first)].object;
  return {frame_.position(v[0]), gpu::kPrimitiveFlatTriangle,
          frame_.position(v[1]), object,
          frame_.position(v[2]), index};
}

gpu::Primitive Primitives::shape(std::uint32_t index) const {
  const Run& run = runOf(index);
  return run.source == Source::kSpheres ? sphere(run, index) : triangle(run, index, vertices(run, index));
}

// Of a triangle: rounding keeps the order of coordinates, so it may come after finding the least and the
// largest.
Box Primitives::box(std::uint32_t index) const {
  const Run& run = runOf(index);
  if (run.source == Source::kSpheres) return boundingBox(sphere(run, index));
  const auto [a, b, c] = vertices(run, index);
  return {frame_.position(glm::min(glm::min(a, b), c)), frame_.position(glm::max(glm::max(a, b), c))};
}

// Step by step, each for a block of triangles: the divisions and square roots of one wait for one another,
// those of several do not.
void Primitives::make(std::span<const std::uint32_t> indices, std::span<gpu::Primitive> shapes,
                      std::span<gpu::TrianglePlane> planes) const {
  constexpr std::size_t kBlockSize = 64;
  struct Corner {
    glm::dvec3 position{0.0};
    std::array<glm::dvec3, 2> edges{};
  };
  std::array<Corner, kBlockSize> corners;
  for (std::size_t begin = 0; begin < indices.size(); begin += kBlockSize) {
    const std::size_t count = std::min(kBlockSize, indices.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t index = indices[begin + i];
      const Run& run = runOf(index);
      corners[i] = {};
      if (run.source == Source::kSpheres) {
        shapes[begin + i] = sphere(run, index);
        continue;
      }
      const std::array<glm::dvec3, 3> v = vertices(run, index);
      shapes[begin + i] = triangle(run, index, v);
      corners[i] = {v[0], {v[1] - v[0], v[2] - v[0]}};
    }
    if (planes.empty()) continue;
    for (std::size_t i = 0; i < count; ++i) {
      for (glm::dvec3& edge : corners[i].edges) edge = unitOrZero(edge);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [position, edges] = corners[i];
      const glm::dvec3 normal = unitOrZero(glm::cross(edges[0], edges[1]));
      planes[begin + i] = {toFloat(normal), frame_.planeDistance(normal, position)};
    }
  }
}

bool Primitives::hasCornerNormals(std::uint32_t index) const {
  const Run& run = runOf(index);
  return run.mesh != nullptr && run.mesh->triangles[index - run.first].normals[0] != kNoNormal;
}

// Keeps the normals' relative lengths, since interpolation depends on them, but scales all three into the
// range where float32 preserves their directions.
std::array<gpu::CornerNormal, 3> Primitives::cornerNormals(std::uint32_t index) const {
  const Run& run = runOf(index);
  const std::array<std::uint32_t, 3>& normals = run.mesh->triangles[index - run.first].normals;
  double largest = 0.0;
  for (const std::uint32_t n : normals) largest = std::max(largest, largestComponent(run.mesh->normals[n]));
  std::array<gpu::CornerNormal, 3> result;
  for (int i = 0; i < 3; ++i) {
    result[i] = {toFloat(largest > 0.0 ? run.mesh->normals[normals[i]] / largest : glm::dvec3(0.0)), 0};
  }
  return result;
}

std::size_t primitiveCount(const Scene& scene) {
  std::size_t count = scene.spheres.size() + scene.triangles.size();
  for (const MeshObject& mesh : scene.meshObjects) count += scene.meshes[mesh.mesh].triangles.size();
  return count;
}

Box boundingBox(const gpu::Primitive& shape) {
  Box box;
  if (shape.kind != gpu::kPrimitiveSphere) {
    box.extend(shape.a);
    box.extend(shape.b);
    box.extend(shape.c);
    return box;
  }
  // centre -+ radius is rounded, so each bound moves outwards by one float.
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = std::nextafter(shape.a[axis] - shape.b.x, -INFINITY);
    box.upper[axis] = std::nextafter(shape.a[axis] + shape.b.x, INFINITY);
  }
  return box;
}

std::vector<std::uint32_t> spheresFirst(const Primitives& primitives) {
  std::vector<std::uint32_t> result(primitives.size());
  std::iota(result.begin(), result.end(), 0U);
  std::ranges::stable_partition(
      result, [&](std::uint32_t i) { return primitives.shape(i).kind == gpu::kPrimitiveSphere; });
  return result;
}

std::vector<std::uint32_t> withoutCoincident(const Primitives& primitives) {
  std::unordered_map<ShapeKey, int, ShapeKeyHash> seen;
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < primitives.size(); ++i) {
    const gpu::Primitive shape = primitives.shape(i);
    const int allowed = shape.kind == gpu::kPrimitiveSphere ? 2 : 1;
    if (seen[keyOf(shape)]++ < allowed) kept.push_back(i);
  }
  return kept;
}

}  // namespace lavaray
