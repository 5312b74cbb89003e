// No ray passes between two triangles that share an edge or a vertex.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "bvh/flatten.hpp"
#include "device/trace_rays.hpp"
#include "stress/report.hpp"
#include "support/scene_building.hpp"

namespace lavaray {
namespace {

// A closed mesh of 8,064 triangles, and where a ray may start to be inside for sure.
struct ClosedMesh {
  std::string name;
  Scene scene;
  glm::dvec3 center;
  double innerExtent;
};

// The place is a float, and so are the vertices: the mesh is closed after its coordinates are rounded.
ClosedMesh closedMesh(const std::string& name, double bump, const glm::dvec3& place, double radius) {
  Random random(7);
  Grid grid = sphereGrid(64, bump, random);
  for (auto& ring : grid) {
    for (glm::dvec3& point : ring) point = glm::dvec3(glm::vec3(place + radius * point));
  }
  ClosedMesh mesh{name, {}, place, 0.3 * radius};
  addGrid(mesh.scene, grid, random);
  return mesh;
}

std::vector<ClosedMesh> closedMeshes() {
  std::vector<ClosedMesh> meshes;
  const glm::dvec3 far(148376.0, 1234.0, -223423.0);
  for (const double bump : {0.0, 0.1}) {
    const std::string kind = bump > 0.0 ? "bumpy" : "smooth";
    meshes.push_back(closedMesh(kind + " at the origin", bump, glm::dvec3(0.0), 1.0));
    meshes.push_back(closedMesh(kind + " at 1e3", bump, glm::dvec3(1000.0), 1.0));
    meshes.push_back(closedMesh(kind + " at 2e5", bump, far, 100.0));
    // A unit in the last place is 1/64 there: most triangles are slivers, many have no area.
    meshes.push_back(closedMesh(kind + " and coarse at 2e5", bump, far, 2.0));
  }
  return meshes;
}

enum class Aim { kEdges, kVertices };

gpu::ProbeRay rayOutOf(const ClosedMesh& mesh, Aim aim, Random& random) {
  std::uniform_real_distribution<double> along(0.0, 1.0);
  const auto& v = mesh.scene.triangles[random() % mesh.scene.triangles.size()].vertices;
  const std::size_t corner = random() % 3;
  const glm::dvec3 from = v[corner];
  const glm::dvec3 target =
      aim == Aim::kVertices ? from : from + along(random) * (v[(corner + 1) % 3] - from);
  const glm::vec3 origin(mesh.center + randomPoint(random, mesh.innerExtent));
  return {origin, kNoSkip, glm::vec3(target) - origin, INFINITY};
}

void expectNoLeaks(Aim aim) {
  const std::vector<ClosedMesh> meshes = closedMeshes();
  const std::size_t rayCount = sized(125'000, 1'000'000);
  std::size_t total = 0;
  std::size_t leaks = 0;
  for (const ClosedMesh& mesh : meshes) {
    Random random(11);
    std::vector<gpu::ProbeRay> rays(rayCount);
    for (gpu::ProbeRay& ray : rays) ray = rayOutOf(mesh, aim, random);
    const auto hits = traceRays(flatten(mesh.scene, 2), rays, gpu::kTraceClosest);
    const auto missed = static_cast<std::size_t>(
        std::count_if(hits.begin(), hits.end(), [](const auto& hit) { return hit.order == kMiss; }));
    EXPECT_EQ(missed, 0U) << mesh.name;
    EXPECT_TRUE(std::all_of(hits.begin(), hits.end(), [](const auto& hit) { return hit.finished == 1; }));
    total += rayCount;
    leaks += missed;
  }
  report(grouped(leaks) + " leaks in " + grouped(total) + " rays out of " + std::to_string(meshes.size()) +
         " closed meshes of " + grouped(meshes[0].scene.triangles.size()) + " triangles");
}

TEST(Watertight, NoRayLeaksThroughAnEdge) {
  expectNoLeaks(Aim::kEdges);
}

TEST(Watertight, NoRayLeaksThroughAVertex) {
  expectNoLeaks(Aim::kVertices);
}

// A disc of triangles about one vertex, in a plane that is parallel to no axis.
struct Fan {
  Scene scene;
  glm::dvec3 hub;
  std::vector<glm::dvec3> rim;
};

Fan closedFan(std::size_t triangles, Random& random) {
  const glm::dvec3 u(0.6, 0.0, -0.8);
  const glm::dvec3 v(0.64, 0.6, 0.48);
  Fan fan{{}, glm::dvec3(glm::vec3(0.1, 0.2, -7.0)), {}};
  std::uniform_real_distribution<double> radius(1.0, 3.0);
  for (std::size_t i = 0; i < triangles; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(triangles);
    const glm::dvec3 spoke = std::cos(angle) * u + std::sin(angle) * v;
    fan.rim.push_back(glm::dvec3(glm::vec3(fan.hub + radius(random) * spoke)));
  }
  for (std::size_t i = 0; i < triangles; ++i) {
    addTriangle(fan.scene, fan.hub, fan.rim[i], fan.rim[(i + 1) % triangles]);
  }
  return fan;
}

// Half of the rays are aimed at the vertex that all triangles share, half at the edges between them.
TEST(Watertight, EveryRayThroughAClosedFanHitsOnce) {
  Random random(13);
  std::size_t total = 0;
  std::size_t wrong = 0;
  double largestError = 0.0;
  for (std::size_t triangles = 4; triangles <= 1024; triangles *= 2) {
    const Fan fan = closedFan(triangles, random);
    const std::size_t rayCount = sized(10'000, 200'000);
    std::uniform_real_distribution<double> along(0.0, 0.999);
    std::vector<gpu::ProbeRay> rays;
    for (std::size_t i = 0; i < rayCount; ++i) {
      const glm::dvec3 spoke = fan.rim[random() % triangles] - fan.hub;
      const glm::dvec3 target = fan.hub + (i % 2 == 0 ? 0.0 : along(random)) * spoke;
      const glm::vec3 origin(randomPoint(random, 1.0));
      rays.push_back({origin, kNoSkip, glm::vec3(target) - origin, INFINITY});
    }
    const auto hits = traceRays(flatten(fan.scene, 2), rays, gpu::kTraceClosest);
    for (const gpu::ProbeHit& hit : hits) {
      // The target, which the direction ends in, is the one point where the ray meets the fan's plane.
      const double error = hit.order == kMiss ? INFINITY : std::abs(double{hit.t} - 1.0);
      largestError = std::max(largestError, error);
      if (error > 1e-5) ++wrong;
    }
    total += rayCount;
  }
  EXPECT_EQ(wrong, 0U);
  report(
      grouped(wrong) + " of " + grouped(total) +
      " rays at the edges of closed fans of 4 to 1,024 triangles without exactly one hit at its place; t is "
      "off by at most " +
      shortNumber(largestError));
}

}  // namespace
}  // namespace lavaray
