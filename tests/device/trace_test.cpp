// What the traversal promises besides finding the nearest hit, which tests/stress/traversal.cpp is about.
#include <gtest/gtest.h>

#include <random>

#include "bvh/flatten.hpp"
#include "device/trace_rays.hpp"
#include "support/scene_building.hpp"

namespace lavaray {
namespace {

// Of coincident triangles the first in the file is hit, however the tree is traversed.
TEST(Traversal, PrefersTheFirstOfEqualHits) {
  Random random(8);
  Scene scene;
  for (int copy = 0; copy < 40; ++copy) {
    addTriangle(scene, {-1, -1, -5}, {1, -1, -5}, {0, 1, -5});
    addSphere(scene, {0, 3, -5}, 1.0);
  }
  std::vector<gpu::ProbeRay> rays;
  for (int i = 0; i < 1000; ++i) {
    std::uniform_real_distribution<float> offset(-0.2F, 0.2F);
    const float y = i % 2 == 0 ? 0.0F : 3.0F;
    rays.push_back({glm::vec3(0.0F), kNoSkip, {offset(random), y + offset(random), -5.0F}, INFINITY});
  }
  const auto hits = traceRays(flatten(scene, 2), rays, gpu::kTraceClosest);
  for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_EQ(hits[i].order, i % 2 == 0 ? 0U : 1U);
}

// A ray that passes through more boxes than a traversal has steps, or the device loop turns, is reported,
// never cut short. Between the two counts it is the device's choice.
TEST(Traversal, SaysWhereItGivesUp) {
  for (const int count : {1000, 60'000, 600'000}) {
    Scene scene;
    for (int i = 0; i < count; ++i) {
      const double z = -10.0 - 0.001 * i;
      addTriangle(scene, {0, 0, z}, {1, 0, z}, {0, 1, z});
    }
    // Beyond the hypotenuse, but within every box.
    const std::vector<gpu::ProbeRay> rays(64,
                                          gpu::ProbeRay{{0.9F, 0.9F, 0.0F}, kNoSkip, {0, 0, -1}, INFINITY});
    for (const gpu::ProbeHit& hit : traceRays(flatten(scene, 2), rays, gpu::kTraceClosest)) {
      EXPECT_EQ(hit.order, kMiss);
      if (count != 60'000) {
        EXPECT_EQ(hit.finished, count == 1000 ? 1U : 0U);
      }
    }
  }
}

}  // namespace
}  // namespace lavaray
