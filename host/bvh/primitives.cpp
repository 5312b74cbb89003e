#include "bvh/primitives.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/errors.hpp"
#include "base/text_location.hpp"
#include "base/vector_math.hpp"
#include "bvh/frame.hpp"

namespace lavaray {
namespace {

class Collector {
 public:
  Collector(const Scene& scene, std::size_t shapes) : scene_(scene), frame_(frameOf(scene)) {
    std::size_t cornerNormals = 0;
    for (const MeshObject& mesh : scene.meshObjects) {
      const Mesh& file = scene.meshes[mesh.mesh];
      if (!file.normals.empty()) cornerNormals += 3 * file.triangles.size();
    }
    result_.shapes.reserve(shapes);
    if (hasTriangles()) result_.planes.reserve(shapes);
    result_.cornerNormals.reserve(cornerNormals);
  }

  // In file order: each of the scene's arrays is sorted by object, so this merges them.
  Primitives collect() {
    std::size_t sphere = 0;
    std::size_t triangle = 0;
    std::size_t mesh = 0;
    for (std::uint32_t object = 0; object < scene_.materials.size(); ++object) {
      if (sphere < scene_.spheres.size() && scene_.spheres[sphere].object == object) {
        addSphere(scene_.spheres[sphere++]);
      } else if (triangle < scene_.triangles.size() && scene_.triangles[triangle].object == object) {
        addTriangle(scene_.triangles[triangle++].vertices, object, gpu::kPrimitiveFlatTriangle);
      } else if (mesh < scene_.meshObjects.size() && scene_.meshObjects[mesh].object == object) {
        addMesh(scene_.meshes[scene_.meshObjects[mesh++].mesh], object);
      }
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] gpu::uint nextOrder() const { return static_cast<gpu::uint>(result_.shapes.size()); }

  void addSphere(const Sphere& sphere) {
    const glm::vec3 radius(frame_.length(sphere.radius), 0.0F, 0.0F);
    result_.shapes.push_back({frame_.position(sphere.center), gpu::kPrimitiveSphere, radius, sphere.object,
                              glm::vec3(0.0F), nextOrder()});
    if (hasTriangles()) result_.planes.push_back({glm::vec3(0.0F), 0.0F});
  }

  void addTriangle(const std::array<glm::dvec3, 3>& v, std::uint32_t object, gpu::uint firstCornerNormal) {
    const glm::dvec3 normal = unitOrZero(glm::cross(unitOrZero(v[1] - v[0]), unitOrZero(v[2] - v[0])));
    result_.shapes.push_back({frame_.position(v[0]), firstCornerNormal, frame_.position(v[1]), object,
                              frame_.position(v[2]), nextOrder()});
    result_.planes.push_back({toFloat(normal), frame_.planeDistance(normal, v[0])});
  }

  void addMesh(const Mesh& mesh, std::uint32_t object) {
    for (const MeshTriangle& triangle : mesh.triangles) {
      gpu::uint firstCornerNormal = gpu::kPrimitiveFlatTriangle;
      if (triangle.normals[0] != kNoNormal) {
        firstCornerNormal = static_cast<gpu::uint>(result_.cornerNormals.size());
        addCornerNormals(mesh, triangle);
      }
      const auto [a, b, c] = triangle.positions;
      addTriangle({mesh.positions[a], mesh.positions[b], mesh.positions[c]}, object, firstCornerNormal);
    }
  }

  // Keeps the normals' relative lengths, since interpolation depends on them, but scales all three into the
  // range where float32 preserves their directions.
  void addCornerNormals(const Mesh& mesh, const MeshTriangle& triangle) {
    double largest = 0.0;
    for (const std::uint32_t n : triangle.normals)
      largest = std::max(largest, largestComponent(mesh.normals[n]));
    for (const std::uint32_t n : triangle.normals) {
      result_.cornerNormals.push_back(
          {toFloat(largest > 0.0 ? mesh.normals[n] / largest : glm::dvec3(0.0)), 0});
    }
  }

  [[nodiscard]] bool hasTriangles() const { return !scene_.triangles.empty() || !scene_.meshObjects.empty(); }

  const Scene& scene_;
  Frame frame_;
  Primitives result_;
};

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

std::size_t primitiveCount(const Scene& scene) {
  std::size_t count = scene.spheres.size() + scene.triangles.size();
  for (const MeshObject& mesh : scene.meshObjects) count += scene.meshes[mesh.mesh].triangles.size();
  return count;
}

Primitives collectPrimitives(const Scene& scene) {
  const std::size_t count = primitiveCount(scene);
  if (count > gpu::kMaxReference) {
    throw Error(ExitCode::kInput, printable(scene.file.native()) + ": " + std::to_string(count) +
                                      " spheres and triangles; at most " +
                                      std::to_string(gpu::kMaxReference) + " are allowed");
  }
  return Collector(scene, count).collect();
}

void putSpheresFirst(Primitives& primitives) {
  const std::vector<gpu::Primitive> shapes = std::exchange(primitives.shapes, {});
  const std::vector<gpu::TrianglePlane> planes = std::exchange(primitives.planes, {});
  for (const bool spheres : {true, false}) {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if ((shapes[i].kind == gpu::kPrimitiveSphere) != spheres) continue;
      primitives.shapes.push_back(shapes[i]);
      if (!planes.empty()) primitives.planes.push_back(planes[i]);
    }
  }
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

std::size_t removeCoincident(Primitives& primitives) {
  std::unordered_map<ShapeKey, int, ShapeKeyHash> seen;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < primitives.shapes.size(); ++i) {
    const gpu::Primitive& shape = primitives.shapes[i];
    const int allowed = shape.kind == gpu::kPrimitiveSphere ? 2 : 1;
    if (seen[keyOf(shape)]++ >= allowed) continue;
    primitives.shapes[kept] = shape;
    if (!primitives.planes.empty()) primitives.planes[kept] = primitives.planes[i];
    ++kept;
  }
  const std::size_t removed = primitives.shapes.size() - kept;
  primitives.shapes.resize(kept);
  if (!primitives.planes.empty()) primitives.planes.resize(kept);
  return removed;
}

}  // namespace lavaray
