#include "core/frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/vector.hpp"

namespace lavaray {
namespace {

// The largest coordinate of a scene, or some coordinate that is at least 1: most scenes have one right at the
// start.
class LargestCoordinate {
 public:
  explicit LargestCoordinate(const Scene& scene) : origin_(scene.camera.position) {
    for (const Sphere& sphere : scene.spheres) add(sphere.center, sphere.radius);
    for (const Plane& plane : scene.planes) {
      addLength(std::abs(glm::dot(unitOrZero(plane.normal), plane.point - origin_)));
    }
    for (const Light& light : scene.lights) add(light.position, light.radius);
    for (const Triangle& triangle : scene.triangles) {
      for (const glm::dvec3& vertex : triangle.vertices) add(vertex);
    }
    for (const MeshObject& object : scene.meshObjects) addMesh(scene.meshes[object.mesh]);
  }
  [[nodiscard]] double value() const { return largest_; }

 private:
  void addLength(double length) { largest_ = std::max(largest_, length); }
  void add(const glm::dvec3& point, double radius = 0.0) {
    addLength(std::max(largestComponent(point - origin_), radius));
  }
  void addMesh(const Mesh& mesh) {
    for (const MeshTriangle& triangle : mesh.triangles) {
      if (largest_ >= 1.0) return;
      for (const std::uint32_t vertex : triangle.positions) add(mesh.positions[vertex]);
    }
  }

  glm::dvec3 origin_;
  double largest_ = 0.0;
};

}  // namespace

glm::vec3 Frame::position(const glm::dvec3& point) const {
  return toFloat(scale * (point - origin));
}

float Frame::length(double length) const {
  return toFloat(scale * length);
}

float Frame::planeDistance(const glm::dvec3& normal, const glm::dvec3& point) const {
  return toFloat(scale * glm::dot(normal, point - origin));
}

Frame frameOf(const Scene& scene) {
  constexpr int kMaxExponent = 1000;  // of a double that no power of two takes beyond the largest one
  const double largest = LargestCoordinate(scene).value();
  if (largest >= 1.0 || largest == 0.0) return {scene.camera.position, 1.0};
  return {scene.camera.position, std::ldexp(1.0, std::min(-std::ilogb(largest), kMaxExponent))};
}

float toFloat(double value) {
  const auto rounded = static_cast<float>(value);
  return std::abs(rounded) < std::numeric_limits<float>::min() ? 0.0F : rounded;
}

glm::vec3 toFloat(const glm::dvec3& v) {
  return {toFloat(v.x), toFloat(v.y), toFloat(v.z)};
}

}  // namespace lavaray
