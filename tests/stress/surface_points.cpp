// Hit points lie on their surface, and normals have unit length, against double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "bvh/flatten.hpp"
#include "scene/scene_reader.hpp"
#include "stress/report.hpp"
#include "stress/surface_probe.hpp"

namespace lavaray {
namespace {

// A unit in the last place of a float of this size.
double ulpOf(double size) {
  return std::ldexp(1.0, std::ilogb(size) - 23);
}

std::vector<gpu::SurfaceQuery> raysAt(const SurfaceScene& scene, std::size_t count) {
  Random random(47);
  std::vector<gpu::SurfaceQuery> queries(count);
  for (gpu::SurfaceQuery& query : queries) query = rayAtSurface(scene, random);
  return queries;
}

struct Outcome {
  std::size_t points = 0;
  double largest = 0.0;
};

// `offSurface` is a function of a scene and an answer: how far the point is off, in units of what is allowed.
template <typename OffSurface>
Outcome findPointsOf(const std::vector<SurfaceScene>& scenes, const OffSurface& offSurface) {
  Outcome outcome;
  const std::size_t count = sized(100'000, 1'000'000) / scenes.size();
  for (const SurfaceScene& scene : scenes) {
    double largest = 0.0;
    std::size_t points = 0;
    for (const gpu::SurfaceAnswer& answer : findPoints(flatten(scene.scene, 2), raysAt(scene, count))) {
      if (answer.surface == kNoSurface) continue;
      const double off = offSurface(scene.scene, answer);
      largest = std::isnan(off) ? INFINITY : std::max(largest, off);
      ++points;
    }
    EXPECT_LE(largest, 1.0) << scene.name;
    EXPECT_GT(points, count / 5) << scene.name;
    outcome.points += points;
    outcome.largest = std::max(outcome.largest, largest);
  }
  return outcome;
}

TEST(HitPoint, LiesOnItsSphere) {
  const Outcome outcome =
      findPointsOf(sphereScenes(), [](const Scene& scene, const gpu::SurfaceAnswer& answer) {
        const auto& [center, radius, object] = scene.spheres[answer.order];
        const double height = std::abs(glm::distance(glm::dvec3(answer.position), center) - radius);
        return height / (4e-7 * (radius + glm::length(center)));
      });
  report("off by at most " + shortNumber(outcome.largest) + " times 4e-7 (r + |c|) at " +
         grouped(outcome.points) + " points");
}

TEST(HitPoint, LiesOnItsPlane) {
  const Outcome outcome =
      findPointsOf(planeScenes(), [](const Scene& scene, const gpu::SurfaceAnswer& answer) {
        const Plane& plane = scene.planes[answer.surface & 0x7FFFFFFFU];
        const glm::dvec3 p(answer.position);
        const double height = std::abs(glm::dot(glm::normalize(plane.normal), p - plane.point));
        return height / (4.0 * ulpOf(glm::length(p)));
      });
  report("off by at most " + shortNumber(4.0 * outcome.largest) + " ulp of |p| at " +
         grouped(outcome.points) + " points");
}

TEST(HitPoint, LiesOnItsTriangle) {
  std::vector<SurfaceScene> scenes = triangleScenes();
  for (const auto& more : {sliverScenes(), hugeTriangleScenes()}) {
    scenes.insert(scenes.end(), more.begin(), more.end());
  }
  const Outcome outcome = findPointsOf(scenes, [](const Scene& scene, const gpu::SurfaceAnswer& answer) {
    const auto& v = scene.triangles[answer.order].vertices;
    const glm::dvec3 normal = glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
    const double height = std::abs(glm::dot(normal, glm::dvec3(answer.position) - v[0]));
    return height / (8.0 * ulpOf(std::max({glm::length(v[0]), glm::length(v[1]), glm::length(v[2])})));
  });
  report("off by at most " + shortNumber(8.0 * outcome.largest) + " ulp of the farthest vertex at " +
         grouped(outcome.points) + " points");
}

// Besides the random surfaces a mesh with interpolated normals.
TEST(Normal, HasUnitLength) {
  std::vector<SurfaceScene> scenes;
  for (const auto& more :
       {sphereScenes(), triangleScenes(), sliverScenes(), hugeTriangleScenes(), planeScenes()}) {
    scenes.insert(scenes.end(), more.begin(), more.end());
  }
  const auto offUnit = [](const Scene&, const gpu::SurfaceAnswer& answer) {
    const double geometric = std::abs(glm::length(glm::dvec3(answer.geometricNormal)) - 1.0);
    const double shading = std::abs(glm::length(glm::dvec3(answer.shadingNormal)) - 1.0);
    return std::max(geometric, shading) / 3e-7;
  };
  Outcome outcome = findPointsOf(scenes, offUnit);

  const Scene torus = readScene(LAVARAY_SCENES_DIR "/torus.txt");
  Random random(53);
  std::vector<gpu::SurfaceQuery> queries(sized(50'000, 500'000));
  for (gpu::SurfaceQuery& query : queries) {
    const auto& positions = torus.meshes.at(0).positions;
    const glm::dvec3& vertex = positions[random() % positions.size()];
    query.direction = vertex + randomPoint(random, 0.3) - torus.camera.position;
  }
  std::size_t smooth = 0;
  double largest = 0.0;
  for (const gpu::SurfaceAnswer& answer : findPoints(flatten(torus, 2), queries)) {
    if (answer.surface == kNoSurface) continue;
    if (answer.shadingNormal != answer.geometricNormal) ++smooth;
    largest = std::max(largest, offUnit(torus, answer));
  }
  EXPECT_LE(largest, 1.0) << "torus";
  EXPECT_GT(smooth, queries.size() / 10);
  outcome.largest = std::max(outcome.largest, largest);
  report("off by at most " + shortNumber(3e-7 * outcome.largest) + " at " +
         grouped(outcome.points + queries.size()) + " points, " + grouped(smooth) +
         " of them of a smooth mesh");
}

}  // namespace
}  // namespace lavaray
