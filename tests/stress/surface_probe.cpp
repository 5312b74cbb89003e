#include "stress/surface_probe.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "device/probe.hpp"
#include "stress/report.hpp"
#include "surfaceProbeSpirv.spv.h"

namespace lavaray {
namespace {

constexpr int kSurfaces = 64;

// Smaller surfaces than this, in relation to their distance, have hardly a point between their edges.
constexpr double kSmallestSize = 1e-5;

glm::dvec3 rounded(const glm::dvec3& v) {
  return glm::dvec3(glm::vec3(v));
}

std::string nameOf(double size, double offset) {
  return "size " + shortNumber(size) + " at " + shortNumber(offset);
}

// Rays and answers are in the shaders' coordinates. Those are the scene's where it is not enlarged
// (frame.hpp), and beside a light so far away it is not.
void keepFrame(Scene& scene) {
  scene.lights.push_back({.position = {0, 0, 0x1p50}});
}

// `addSurface` adds one to the scene at the given centre.
template <typename AddSurface>
std::vector<SurfaceScene> scenesOfSizes(std::initializer_list<double> sizes, const AddSurface& addSurface) {
  Random random(31);
  std::vector<SurfaceScene> scenes;
  for (const double size : sizes) {
    for (const double offset : {0.0, 1.0, 1e3, 1e5}) {
      if (size < kSmallestSize * offset) continue;
      SurfaceScene scene{nameOf(size, offset), {}, size, offset};
      keepFrame(scene.scene);
      for (int i = 0; i < kSurfaces; ++i) {
        const glm::dvec3 middle = offset * randomDirection(random);
        addSurface(scene.scene, rounded(middle + randomPoint(random, 2.0 * size)), size, random);
      }
      scenes.push_back(std::move(scene));
    }
  }
  return scenes;
}

// On the plane, at most 2^reach sizes away from the point that is nearest to the camera.
glm::dvec3 randomTarget(const glm::dvec3& unitNormal, const glm::dvec3& point, double size, double reach,
                        Random& random) {
  const double distance = size * std::exp2(uniform(random, -10.0, reach));
  const glm::dvec3 away = distance * randomDirection(random);
  return glm::dot(unitNormal, point) * unitNormal + away - glm::dot(away, unitNormal) * unitNormal;
}

glm::dvec3 randomTarget(const SurfaceScene& surfaces, Random& random) {
  const Scene& scene = surfaces.scene;
  if (!scene.spheres.empty()) {
    const Sphere& sphere = scene.spheres[random() % scene.spheres.size()];
    const double distance = sphere.radius * std::cbrt(uniform(random, 0.0, 1.0));
    return sphere.center + distance * randomDirection(random);
  }
  if (!scene.triangles.empty()) {
    const auto& v = scene.triangles[random() % scene.triangles.size()].vertices;
    if (surfaces.isHuge) {
      const glm::dvec3 normal = glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
      return randomTarget(normal, v[0], surfaces.size, 4.0, random);
    }
    const double s = uniform(random, 0.0, 1.0);
    const double r = random() % 8 == 0 ? 1.0 : std::sqrt(uniform(random, 0.0, 1.0));  // 1 is on an edge
    return v[0] + r * ((1.0 - s) * (v[1] - v[0]) + s * (v[2] - v[0]));
  }
  const Plane& plane = scene.planes[random() % scene.planes.size()];
  return randomTarget(glm::normalize(plane.normal), plane.point, surfaces.size, 10.0, random);
}

}  // namespace

std::vector<gpu::SurfaceAnswer> findPoints(const GpuScene& scene,
                                           const std::vector<gpu::SurfaceQuery>& queries) {
  const gpu::SurfaceConstants constants{static_cast<gpu::uint>(queries.size())};
  return runProbe<gpu::SurfaceAnswer>(surfaceProbeSpirv, scene, queries, constants);
}

std::vector<SurfaceScene> sphereScenes() {
  return scenesOfSizes({1e-4, 1e-2, 1.0, 1e2, 1e4},
                       [](Scene& scene, const glm::dvec3& center, double size, Random& random) {
                         const auto radius = static_cast<float>(size * uniform(random, 0.5, 2.0));
                         addSphere(scene, center, radius);
                       });
}

std::vector<SurfaceScene> triangleScenes() {
  return scenesOfSizes({1e-3, 1e-1, 1.0, 1e2},
                       [](Scene& scene, const glm::dvec3& center, double size, Random& random) {
                         glm::dvec3 u;
                         glm::dvec3 v;
                         do {
                           u = randomPoint(random, size);
                           v = randomPoint(random, size);
                         } while (glm::length(glm::cross(u, v)) < 0.05 * size * size);
                         addTriangle(scene, center, rounded(center + u), rounded(center + v));
                       });
}

std::vector<SurfaceScene> sliverScenes() {
  return scenesOfSizes({1e-1, 1.0, 1e2},
                       [](Scene& scene, const glm::dvec3& center, double size, Random& random) {
                         glm::dvec3 b;
                         glm::dvec3 c;
                         // Far away rounding can leave a sliver without area, which the reader refuses.
                         do {
                           const glm::dvec3 u = size * randomDirection(random);
                           const glm::dvec3 v = 0.5 * u + randomPoint(random, 1e-3 * size);
                           b = rounded(center + u);
                           c = rounded(center + v);
                         } while (glm::cross(b - center, c - center) == glm::dvec3(0.0));
                         addTriangle(scene, center, b, c);
                       });
}

std::vector<SurfaceScene> hugeTriangleScenes() {
  Random random(43);
  std::vector<SurfaceScene> scenes;
  for (const double extent : {1e2, 1e4, 1e6}) {
    SurfaceScene scene{"extent " + shortNumber(extent) + " at 1", {}, 1.0, 1.0, true};
    for (int i = 0; i < 8; ++i) {
      const glm::dvec3 normal = randomDirection(random);
      const glm::dvec3 u = glm::normalize(glm::cross(normal, randomDirection(random)));
      const glm::dvec3 v = glm::cross(normal, u);
      const glm::dvec3 place = normal + uniform(random, -1.0, 1.0) * u;
      addTriangle(scene.scene, rounded(place - extent * u), rounded(place + extent * (0.5 * u + 0.8 * v)),
                  rounded(place + extent * (0.5 * u - 0.8 * v)));
    }
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::vector<SurfaceScene> planeScenes() {
  Random random(37);
  std::vector<SurfaceScene> scenes;
  for (const double offset : {0.0, 1e-3, 1.0, 1e3, 1e5}) {
    const double size = offset == 0.0 ? 1.0 : offset;
    SurfaceScene scene{"plane at " + shortNumber(offset), {}, size, offset};
    keepFrame(scene.scene);
    for (int i = 0; i < 8; ++i) {
      const glm::dvec3 normal = rounded(randomDirection(random));
      addPlane(scene.scene, normal, rounded(offset * randomDirection(random)));
    }
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

gpu::SurfaceQuery rayAtSurface(const SurfaceScene& scene, Random& random) {
  const glm::dvec3 target = randomTarget(scene, random);
  gpu::SurfaceQuery query{};
  if (random() % 2 == 0) {
    const double distance = scene.size * std::exp2(uniform(random, 0.0, 8.0));
    query.origin = target + distance * randomDirection(random);
  }
  query.direction = target - glm::dvec3(query.origin);
  query.light = glm::vec3(target + scene.size * randomDirection(random));
  return query;
}

}  // namespace lavaray
