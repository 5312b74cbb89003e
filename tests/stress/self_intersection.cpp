// No ray that leaves a surface hits that surface again, and none starts farther from it than it must. The
// rays here are allowed to hit what they leave; the renderer leaves that surface out besides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "bvh/flatten.hpp"
#include "stress/report.hpp"
#include "stress/surface_probe.hpp"

namespace lavaray {
namespace {

struct Outcome {
  std::size_t rays = 0;
  std::size_t selfHits = 0;
  double largestOffset = 0.0;  // in units of what is allowed
};

// Half of the rays leave within 1e-4 radians of the tangent plane.
std::vector<gpu::SurfaceQuery> leavingRays(const SurfaceScene& scene, std::size_t count, bool bothSides,
                                           bool skipThemselves) {
  Random random(41);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<gpu::SurfaceQuery> queries(count);
  for (gpu::SurfaceQuery& query : queries) {
    query = rayAtSurface(scene, random);
    const bool grazing = random() % 2 == 0;
    const double elevation =
        grazing ? 1e-4 * std::pow(1e-4, unit(random)) : 0.5 * std::numbers::pi * unit(random);
    query.elevation = static_cast<float>(bothSides && random() % 2 == 0 ? -elevation : elevation);
    query.skipsItself = skipThemselves ? 1 : 0;
    query.azimuth = static_cast<float>(2.0 * std::numbers::pi * unit(random));
  }
  return queries;
}

// `allowedOffset` is a function of the surface's index in the scene file and the point.
template <typename AllowedOffset>
Outcome leaveSurfaces(const std::vector<SurfaceScene>& scenes, bool bothSides,
                      const AllowedOffset& allowedOffset, bool skipThemselves = false) {
  Outcome outcome;
  const std::size_t count = sized(100'000, 1'000'000) / scenes.size();
  for (const SurfaceScene& scene : scenes) {
    const auto answers =
        findPoints(flatten(scene.scene, 2), leavingRays(scene, count, bothSides, skipThemselves));
    std::size_t selfHits = 0;
    std::size_t rays = 0;
    double largest = 0.0;
    for (const gpu::SurfaceAnswer& answer : answers) {
      if (answer.surface == kNoSurface) continue;
      ++rays;
      selfHits += answer.hitsItself;
      const double offset = glm::distance(glm::dvec3(answer.departure), glm::dvec3(answer.position));
      largest = std::max(largest, offset / allowedOffset(scene.scene, answer));
    }
    EXPECT_EQ(selfHits, 0U) << scene.name;
    EXPECT_LE(largest, 1.0) << scene.name;
    EXPECT_GT(rays, count / 5) << scene.name;
    outcome.rays += rays;
    outcome.selfHits += selfHits;
    outcome.largestOffset = std::max(outcome.largestOffset, largest);
  }
  return outcome;
}

void reportOutcome(const Outcome& outcome, const std::string& allowed) {
  report(grouped(outcome.selfHits) + " self-hits in " + grouped(outcome.rays) +
         " rays, half of them grazing; largest offset " + shortNumber(outcome.largestOffset) + " times " +
         allowed);
}

TEST(LeavingRay, DoesNotHitItsSphereAgain) {
  const Outcome outcome =
      leaveSurfaces(sphereScenes(), false, [](const Scene& scene, const gpu::SurfaceAnswer& answer) {
        return 1e-6 * (glm::length(glm::dvec3(answer.position)) + scene.spheres[answer.order].radius);
      });
  reportOutcome(outcome, "1e-6 (|p| + r)");
}

double allowedForTriangle(const Scene& scene, const gpu::SurfaceAnswer& answer) {
  const auto& v = scene.triangles[answer.order].vertices;
  const double magnitude = std::max({glm::length(v[0]), glm::length(v[1]), glm::length(v[2])});
  const double extent =
      std::max({glm::distance(v[0], v[1]), glm::distance(v[1], v[2]), glm::distance(v[2], v[0])});
  return 1e-6 * (magnitude + extent);
}

TEST(LeavingRay, DoesNotHitItsTriangleAgain) {
  reportOutcome(leaveSurfaces(triangleScenes(), true, allowedForTriangle), "1e-6 (|v| + extent)");
}

// Next to the camera, on triangles that reach far beyond.
TEST(LeavingRay, DoesNotHitItsHugeTriangleAgain) {
  reportOutcome(leaveSurfaces(hugeTriangleScenes(), true, allowedForTriangle), "1e-6 (|v| + extent)");
}

// The distance of a sliver is found with fewer digits than any offset could cover, so it takes the skipping,
// too.
TEST(LeavingRay, DoesNotHitTheSliverThatItSkips) {
  reportOutcome(leaveSurfaces(sliverScenes(), true, allowedForTriangle, true), "1e-6 (|v| + extent)");
}

TEST(LeavingRay, DoesNotHitItsPlaneAgain) {
  const auto allowedForPlane = [](const Scene&, const gpu::SurfaceAnswer& answer) {
    return 1e-6 * glm::length(glm::dvec3(answer.position));
  };
  reportOutcome(leaveSurfaces(planeScenes(), true, allowedForPlane), "1e-6 |p|");
}

}  // namespace
}  // namespace lavaray
