// The share of a subgroup's lanes that are in use while it searches the hierarchy.
#include <gtest/gtest.h>

#include "bvh/flatten.hpp"
#include "device/sampled_image.hpp"
#include "device/test_device.hpp"
#include "render/render.hpp"
#include "support/scene_building.hpp"

namespace lavaray {
namespace {

constexpr int kSide = 64;

// A wall that fills the picture or, moved, its right part, before balls that make it a scene with a
// hierarchy. The light is on the camera's side, so that no shadow ray hits anything.
Scene wall(double left) {
  Scene scene;
  scene.camera = {{0, 0, 0}, 20.0, 100.0, 1.0};
  const Material white = glow(glm::dvec3(0.2));
  for (const double y : {-200.0, 200.0}) {
    const double side = y > 0.0 ? 1.0 : -1.0;
    scene.triangles.push_back(
        {{glm::dvec3(left, side, -5), {left, side * 200.0, -5}, {400, side, -5}}, addObject(scene, white)});
  }
  scene.triangles.push_back(
      {{glm::dvec3(left, -300, -5), {left, 300, -5}, {600, 0, -5}}, addObject(scene, white)});
  for (int i = 0; i < 9; ++i)
    scene.spheres.push_back({{1000.0 + 10.0 * i, 0, -900}, 1.0, addObject(scene, white)});
  scene.lights.push_back({.position = {0, 0, 50}, .ambient = glm::dvec3(0.1), .diffuse = glm::dvec3(0.5)});
  return scene;
}

TraceCounts countsOf(const Scene& scene, std::uint32_t raysPerLane, bool countRays = true) {
  RenderSettings settings = settingsFor({kSide, kSide}, 1);
  settings.countRays = countRays;
  settings.raysPerLane = raysPerLane;
  return render(testDevice(), flatten(scene, 2), settings).counts;
}

TEST(LaneUse, IsAShareThatFallsWhereRaysDiffer) {
  for (const std::uint32_t rays : {1U, 2U, 4U}) {
    const TraceCounts same = countsOf(wall(-300.0), rays);
    const TraceCounts half = countsOf(wall(0.1), rays);
    EXPECT_GT(same.nearestHitLanesInUse(), 0.9) << rays << " rays";
    EXPECT_LE(same.nearestHitLanesInUse(), 1.0) << rays << " rays";
    EXPECT_GT(half.nearestHitLanesInUse(), 0.1) << rays << " rays";
    EXPECT_LT(half.nearestHitLanesInUse(), same.nearestHitLanesInUse()) << rays << " rays";
    EXPECT_GT(same.shadowLanesInUse(), 0.0) << rays << " rays";
    EXPECT_LE(same.shadowLanesInUse(), 1.0) << rays << " rays";
  }
}

TEST(LaneUse, IsCountedOnlyOnRequest) {
  const TraceCounts counts = countsOf(wall(-300.0), 4, false);
  for (const std::uint64_t turns : counts.turns) EXPECT_EQ(turns, 0U);
  EXPECT_EQ(counts.nearestHitLanesInUse(), 0.0);
}

}  // namespace
}  // namespace lavaray
