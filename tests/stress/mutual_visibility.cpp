// Shadow rays find that a sees b where b sees a.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "bvh/flatten.hpp"
#include "device/probe.hpp"
#include "stress/report.hpp"
#include "stress/shaders/stress_probes.h"
#include "support/scene_building.hpp"
#include "visibilityProbeSpirv.spv.h"

namespace lavaray {
namespace {

// A scene with surfaces of all kinds.
Scene symmetryScene() {
  Random random(61);
  Scene scene;
  Grid grid = sphereGrid(32, 0.1, random);
  for (auto& ring : grid) {
    for (glm::dvec3& point : ring) point = 3.0 * point + glm::dvec3(-5.0, 0.0, 1.0);
  }
  addGrid(scene, grid, random);
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 center = randomPoint(random, 10.0);
    addSphere(scene, center, uniform(random, 0.3, 1.5));
  }
  addRandomTriangles(scene, 60, glm::dvec3(0.0), random);
  addPlane(scene, {0.1, 1.0, 0.2}, {0.0, -6.0, 0.0});
  return scene;
}

// Whether the point is farther than `clearance` from every surface, and in no sphere: a sphere is seen from
// outside only. Near a triangle's plane it counts as near the triangle wherever that may reach.
bool isClear(const Scene& scene, const glm::dvec3& p, double clearance) {
  for (const Plane& plane : scene.planes) {
    if (std::abs(glm::dot(glm::normalize(plane.normal), p - plane.point)) < clearance) return false;
  }
  for (const Sphere& sphere : scene.spheres) {
    if (glm::distance(p, sphere.center) < sphere.radius + clearance) return false;
  }
  for (const Triangle& triangle : scene.triangles) {
    const auto& [a, b, c] = triangle.vertices;
    const double reach = std::max(glm::distance(a, b), glm::distance(a, c)) + clearance;
    if (glm::distance(p, a) > reach) continue;
    if (std::abs(glm::dot(glm::normalize(glm::cross(b - a, c - a)), p - a)) < clearance) return false;
  }
  return true;
}

TEST(ShadowRay, FindsTheSameInBothDirections) {
  constexpr double kScale = 10.0;
  const Scene scene = symmetryScene();
  Random random(67);
  std::vector<gpu::PointPair> pairs(sized(100'000, 1'000'000));
  for (gpu::PointPair& pair : pairs) pair = {randomPoint(random, kScale), 0, randomPoint(random, kScale), 0};
  const GpuScene gpuScene = flatten(scene, 2);
  const gpu::SurfaceConstants constants{static_cast<gpu::uint>(pairs.size())};
  const auto answers = runProbe<gpu::PairAnswer>(visibilityProbeSpirv, gpuScene, pairs, constants);

  std::vector<char> clear(pairs.size());
  parallelFor(pairs.size(), hardwareThreads(), [&](std::size_t i) {
    clear[i] = isClear(scene, pairs[i].a, 1e-4 * kScale) && isClear(scene, pairs[i].b, 1e-4 * kScale);
  });
  std::size_t counted = 0;
  std::size_t blocked = 0;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (clear[i] == 0) continue;
    ++counted;
    blocked += answers[i].blockedFromAToB;
    if (answers[i].blockedFromAToB != answers[i].blockedFromBToA) ++differing;
  }
  EXPECT_EQ(differing, 0U);
  EXPECT_GT(counted, pairs.size() / 2);
  EXPECT_GT(blocked, counted / 4);
  EXPECT_LT(blocked, 3 * counted / 4);
  report(grouped(differing) + " of " + grouped(counted) +
         " pairs of points see each other in one direction only, " + grouped(blocked) +
         " do not see each other");
}

}  // namespace
}  // namespace lavaray
