// What the traversal promises besides finding the nearest hit, which tests/stress/traversal.cpp is about.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "bvh/flatten.hpp"
#include "device/trace_rays.hpp"
#include "support/random_numbers.hpp"
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

// Rays that are no numbers hit nothing, and do not keep those that are traced together with them from ending
// and from hitting what they hit alone.
TEST(Traversal, EndsWithRaysThatAreNoNumbers) {
  Random random(9);
  Scene scene;
  for (int i = 0; i < 200; ++i)
    addSphere(scene, {uniform(random, -3.0, 3.0), uniform(random, -3.0, 3.0), -8}, 0.5);
  const GpuScene flat = flatten(scene, 1);
  const std::array<glm::vec3, 3> odd{glm::vec3(NAN), {INFINITY, 0, 0}, {0, NAN, -1}};
  std::vector<gpu::ProbeRay> rays;
  for (std::size_t i = 0; i < 600; ++i) {
    const glm::vec3 direction(uniform(random, -0.4, 0.4), uniform(random, -0.4, 0.4), -1.0);
    rays.push_back({glm::vec3(0.0F), kNoSkip, direction, INFINITY});
    if (i % 3 == 1) rays.back().origin = odd[i / 3 % odd.size()];
    if (i % 7 == 2) rays.back().direction = odd[i / 7 % odd.size()];
  }
  for (const gpu::uint mode : {gpu::kTraceClosest, gpu::kTraceAny}) {
    const auto alone = traceRays(flat, rays, mode);
    EXPECT_GT(std::ranges::count_if(alone, [](const auto& hit) { return hit.order != kMiss; }), 50);
    for (const unsigned raysPerLane : {2U, 4U}) {
      const auto together = traceRays(flat, rays, mode, raysPerLane);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(together[i].finished, 1U) << i;
        EXPECT_EQ(together[i].order == kMiss, alone[i].order == kMiss) << i;
      }
    }
  }
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
