#include "bvh/frame.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/vector_math.hpp"

namespace lavaray {
namespace {

// How far from the camera a scene reaches: its spheres and triangles (near), and its planes and lights, which
// may be much further away (far).
class Extent {
 public:
  explicit Extent(const Scene& scene) : origin_(scene.camera.position) {
    for (const Plane& plane : scene.planes) {
      far_ = std::max(far_, std::abs(glm::dot(unitOrZero(plane.normal), plane.point - origin_)));
    }
    for (const Light& light : scene.lights) far_ = std::max(far_, reach(light.position, light.radius));
    for (const Sphere& sphere : scene.spheres) addNear(reach(sphere.center, sphere.radius));
    for (const Triangle& triangle : scene.triangles) {
      for (const glm::dvec3& vertex : triangle.vertices) addNear(reach(vertex));
    }
    for (const MeshObject& object : scene.meshObjects) addMesh(scene.meshes[object.mesh]);
  }
  // Once it is at least 1 it need not be the maximum: the search stops early, as most scenes have such a
  // coordinate right at the start.
  [[nodiscard]] double near() const { return near_; }
  [[nodiscard]] double far() const { return far_; }

 private:
  [[nodiscard]] double reach(const glm::dvec3& point, double radius = 0.0) const {
    return std::max(largestComponent(point - origin_), radius);
  }
  void addNear(double distance) { near_ = std::max(near_, distance); }
  void addMesh(const Mesh& mesh) {
    for (const MeshTriangle& triangle : mesh.triangles) {
      if (near_ >= 1.0) return;
      for (const std::uint32_t vertex : triangle.positions) addNear(reach(mesh.positions[vertex]));
    }
  }

  glm::dvec3 origin_;
  double near_ = 0.0;
  double far_ = 0.0;
};

}  // namespace

float Frame::planeDistance(const glm::dvec3& normal, const glm::dvec3& point) const {
  return toFloat(scale * glm::dot(normal, point - origin));
}

Frame frameOf(const Scene& scene) {
  constexpr int kMaxExponent = 1000;  // keeps the scale itself finite, however tiny the scene
  // The square of the product of a far distance, below 2^51, and a near one stays finite in float32.
  constexpr int kMaxFarExponent = 50;
  const Extent extent(scene);
  const double measure = extent.near() > 0.0 ? extent.near() : extent.far();
  int exponent = measure > 0.0 ? std::min(-std::ilogb(measure), kMaxExponent) : 0;
  if (extent.far() > 0.0) exponent = std::min(exponent, kMaxFarExponent - std::ilogb(extent.far()));
  return {scene.camera.position, std::ldexp(1.0, std::max(exponent, 0))};
}

}  // namespace lavaray
