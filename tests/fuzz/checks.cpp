#include "fuzz/checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "base/limits.hpp"
#include "bvh/flatten.hpp"
#include "bvh/primitives.hpp"
#include "bvh/wide_bvh.hpp"
#include "scene/camera.hpp"
#include "scene/triangulate.hpp"

namespace lavaray::fuzz {
namespace {

constexpr std::size_t kMaxPrimitives = 10'000;

bool isNumber(double x) {
  return std::abs(x) <= kMaxMagnitude;
}

template <typename Vector>
bool isFinite(const Vector& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isNumber(const glm::dvec3& v) {
  return isNumber(v.x) && isNumber(v.y) && isNumber(v.z);
}

bool isColor(const glm::dvec3& v) {
  return isNumber(v) && std::min({v.x, v.y, v.z}) >= 0.0;
}

void checkMesh(const Mesh& mesh) {
  require(!mesh.triangles.empty(), "a mesh has a triangle");
  require(std::ranges::all_of(mesh.positions, [](const auto& p) { return isNumber(p); }),
          "vertices are numbers");
  require(std::ranges::all_of(mesh.normals, [](const auto& n) { return isNumber(n); }),
          "normals are numbers");
  for (const MeshTriangle& triangle : mesh.triangles) {
    const auto [a, b, c] = triangle.positions;
    require(std::max({a, b, c}) < mesh.positions.size(), "a triangle's vertices exist");
    require(hasArea(mesh.positions[a], mesh.positions[b], mesh.positions[c]), "a triangle has an area");
    const bool hasNormals = triangle.normals[0] != kNoNormal;
    for (const std::uint32_t normal : triangle.normals) {
      require(hasNormals == (normal != kNoNormal), "all corners have a normal, or none");
      require(!hasNormals || normal < mesh.normals.size(), "a triangle's normals exist");
      require(!hasNormals || mesh.normals[normal] != glm::dvec3(0.0), "a triangle's normals are directions");
    }
  }
}

std::size_t countPrimitives(const Scene& scene) {
  std::size_t count = scene.spheres.size() + scene.triangles.size();
  for (const MeshObject& mesh : scene.meshObjects) count += scene.meshes[mesh.mesh].triangles.size();
  return count;
}

// Walks the tree as a ray that hits everything does.
class HierarchyCheck {
 public:
  explicit HierarchyCheck(const GpuScene& scene) : scene_(scene), reached_(scene.primitives.size()) {}

  void run() {
    if (scene_.nodes.empty()) return;
    visit(0, 0);
    require(std::ranges::all_of(reached_, [](int count) { return count == 1; }),
            "a primitive is in one leaf");
  }

 private:
  Box visit(gpu::uint reference, std::uint32_t nodesAbove) {
    if (reference > gpu::kMaxReference) return visitLeaf(reference);
    require(reference < scene_.nodes.size(), "a node's child exists");
    require(nodesAbove <= gpu::kMaxBvhDepth, "no path is longer than the traversal's stack");
    const gpu::BvhNode& node = scene_.nodes[reference];
    require(isFinite(node.origin), "a node's origin is finite");
    Box all;
    for (int i = 0; i < static_cast<int>(gpu::kNodeWidth); ++i) {
      const Box box = childBox(node, i);
      if (glm::any(glm::greaterThan(box.lower, box.upper))) continue;
      require(isFinite(box.lower) && isFinite(box.upper), "a child's box is finite");
      const Box below = visit(node.children[i], nodesAbove + 1);
      require(glm::all(glm::lessThanEqual(box.lower, below.lower)) &&
                  glm::all(glm::greaterThanEqual(box.upper, below.upper)),
              "a child's box holds what is below");
      all.extend(below);
    }
    return all;
  }

  Box visitLeaf(gpu::uint reference) {
    const gpu::uint count = reference >> gpu::kLeafShift;
    const gpu::uint first = reference & gpu::kMaxReference;
    require(count <= gpu::kMaxLeafSize && first + count <= scene_.primitives.size(),
            "a leaf's primitives exist");
    Box all;
    for (gpu::uint i = first; i < first + count; ++i) {
      ++reached_[i];
      all.extend(boundingBox(scene_.primitives[i]));
    }
    return all;
  }

  const GpuScene& scene_;
  std::vector<int> reached_;
};

bool hasUnitLength(const glm::vec3& v) {
  return std::abs(glm::length(glm::dvec3(v)) - 1.0) < 1e-6;
}

void checkPrimitives(const GpuScene& flat) {
  for (const gpu::Primitive& primitive : flat.primitives) {
    require(isFinite(primitive.a) && isFinite(primitive.b) && isFinite(primitive.c), "primitives are finite");
    require(primitive.object < flat.materials.size(), "a primitive has a material");
    if (primitive.kind == gpu::kPrimitiveSphere || primitive.kind == gpu::kPrimitiveFlatTriangle) continue;
    require(primitive.kind + 3 <= flat.cornerNormals.size(), "a triangle's corner normals exist");
  }
  require(flat.trianglePlanes.size() == (flat.hasTriangles ? flat.primitives.size() : 0),
          "a plane a primitive");
  for (const gpu::TrianglePlane& plane : flat.trianglePlanes) {
    require(hasUnitLength(plane.normal) || plane.normal == glm::vec3(0.0F),
            "a face's normal has unit length");
    require(std::isfinite(plane.distance), "a face's distance is finite");
  }
  for (const gpu::CornerNormal& corner : flat.cornerNormals) {
    require(isFinite(corner.normal), "corner normals are finite");
  }
}

}  // namespace

void require(bool condition, std::string_view what) {
  if (condition) return;
  std::fprintf(stderr, "does not hold: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

void checkScene(const Scene& scene) {
  require(imageSize(scene.camera).has_value() && isNumber(scene.camera.position),
          "the camera gives an image");
  for (const Plane& plane : scene.planes) {
    require(isNumber(plane.normal) && isNumber(plane.point), "planes are numbers");
    require(plane.normal != glm::dvec3(0.0), "a plane has a normal");
  }
  for (const Sphere& sphere : scene.spheres) {
    require(isNumber(sphere.center) && isNumber(sphere.radius) && sphere.radius > 0.0, "spheres are numbers");
  }
  for (const Triangle& triangle : scene.triangles) {
    const auto& [a, b, c] = triangle.vertices;
    require(isNumber(a) && isNumber(b) && isNumber(c) && hasArea(a, b, c), "triangles have an area");
  }
  for (const Mesh& mesh : scene.meshes) checkMesh(mesh);
  for (const MeshObject& mesh : scene.meshObjects)
    require(mesh.mesh < scene.meshes.size(), "an object's mesh exists");
  for (const Material& m : scene.materials) {
    require(isColor(m.ambient) && isColor(m.diffuse) && isColor(m.specular) && isColor(m.reflectance) &&
                isNumber(m.shininess) && m.shininess >= 0.0,
            "materials are not negative");
  }
  for (const Light& light : scene.lights) {
    require(isNumber(light.position) && isColor(light.ambient) && isColor(light.diffuse) &&
                isColor(light.specular) && isNumber(light.radius) && light.radius >= 0.0,
            "lights are not negative");
  }
  const std::size_t objects =
      scene.planes.size() + scene.spheres.size() + scene.triangles.size() + scene.meshObjects.size();
  require(scene.materials.size() == objects, "every object has a material");
}

void checkFlattened(const Scene& scene) {
  const std::size_t primitives = countPrimitives(scene);
  if (primitives > kMaxPrimitives) return;
  const GpuScene flat = flatten(scene, 1);
  require(flat.primitives.size() + flat.droppedDuplicates == primitives, "no primitive is lost");
  require(std::isfinite(flat.bvhQuality.sahCost) && flat.bvhQuality.depth <= gpu::kMaxBvhDepth,
          "the hierarchy's figures are finite");
  checkPrimitives(flat);
  HierarchyCheck(flat).run();
  for (const gpu::Plane& plane : flat.planes) {
    require(hasUnitLength(plane.normal) && std::isfinite(plane.distance),
            "planes have a normal of unit length");
  }
  for (const gpu::Light& light : flat.lights) {
    require(isFinite(light.position) && isFinite(light.ambient) && isFinite(light.diffuse) &&
                isFinite(light.specular) && std::isfinite(light.radius),
            "lights are finite");
  }
  for (const gpu::Material& m : flat.materials) {
    require(isFinite(m.ambient) && isFinite(m.diffuse) && isFinite(m.specular) && isFinite(m.reflectance) &&
                std::isfinite(m.shininess),
            "materials are finite");
  }
}

void checkComplaint(const Error& error) {
  require(error.exitCode() == ExitCode::kInput, "a complaint is about the input");
  checkMessage(error.what());
}

void checkMessage(std::string_view message) {
  const std::size_t line = std::min(message.find(':'), message.size() - 1) + 1;
  const std::size_t end = std::min(message.find_first_not_of("0123456789", line), message.size());
  require(line > 1 && end > line && message[line] != '0' && message.substr(end).starts_with(": "),
          "a message names a line of a file");
  require(std::ranges::none_of(message, [](unsigned char c) { return c < 0x20 || c == 0x7F; }),
          "a message can be printed");
}

}  // namespace lavaray::fuzz
