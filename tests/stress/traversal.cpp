// The device's traversal against brute force with the same primitive tests: the same hit, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "bvh/flatten.hpp"
#include "device/trace_rays.hpp"
#include "stress/report.hpp"
#include "stress/traversal_scenes.hpp"
#include "support/random_numbers.hpp"

namespace lavaray {
namespace {

class ClosestHit : public testing::TestWithParam<TraversalScene> {};
INSTANTIATE_TEST_SUITE_P(, ClosestHit, testing::ValuesIn(traversalScenes()), traversalSceneName);

TEST_P(ClosestHit, EqualsBruteForce) {
  const auto [scene, rays] = GetParam().make(sized(100'000, 1'000'000));
  const GpuScene gpuScene = flatten(scene, 2);
  const std::vector<gpu::ProbeHit> closest = traceRays(gpuScene, rays, gpu::kTraceClosest);
  const std::vector<gpu::ProbeHit> expected = traceRays(gpuScene, rays, gpu::kTraceBruteForce);
  std::size_t hits = 0;
  std::size_t wrong = 0;
  std::size_t ties = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(closest[i].finished, 1U);
    ASSERT_EQ(expected[i].finished, 1U);
    // Of several hits at one distance both must name the first in the file, so the primitive must match, too.
    if (expected[i].order != kMiss) ++hits;
    if (closest[i].t != expected[i].t) {
      ++wrong;
    } else if (closest[i].order != expected[i].order) {
      ++ties;
    }
  }
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(ties, 0U);
  EXPECT_GT(hits, rays.size() / 20);
  report(grouped(wrong) + " hits in " + grouped(rays.size()) + " rays differ from brute force, " +
         grouped(ties) + " name another primitive at the same distance, " + grouped(hits) +
         " rays hit one of " + grouped(gpuScene.primitives.size()) + " primitives; depth of the tree " +
         std::to_string(gpuScene.bvhQuality.depth));
  for (const unsigned raysPerLane : {2U, 4U}) {
    const std::vector<gpu::ProbeHit> together = traceRays(gpuScene, rays, gpu::kTraceClosest, raysPerLane);
    const auto isSame = [](const gpu::ProbeHit& a, const gpu::ProbeHit& b) {
      return a.t == b.t && a.order == b.order && a.finished == b.finished;
    };
    EXPECT_TRUE(std::ranges::equal(closest, together, isSame)) << raysPerLane << " rays together";
  }
}

class AnyHit : public testing::TestWithParam<TraversalScene> {};
INSTANTIATE_TEST_SUITE_P(, AnyHit, testing::ValuesIn(traversalScenes()), traversalSceneName);

// Something is hit within a random distance exactly where the closest hit is nearer than that.
TEST_P(AnyHit, EqualsClosestHitNearerThanTheEnd) {
  auto [scene, rays] = GetParam().make(sized(100'000, 1'000'000));
  const GpuScene gpuScene = flatten(scene, 2);
  const std::vector<gpu::ProbeHit> closest = traceRays(gpuScene, rays, gpu::kTraceClosest);
  Random random(99);
  std::uniform_real_distribution<float> factor(0.3F, 1.7F);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const float length = factor(random);
    rays[i].tMax = closest[i].order == kMiss ? 1.0F : closest[i].t * length;
    if (i % 16 == 0 && closest[i].order != kMiss) rays[i].tMax = closest[i].t;  // not nearer, but equal
  }
  for (const unsigned raysPerLane : {1U, 2U, 4U}) {
    const std::vector<gpu::ProbeHit> any = traceRays(gpuScene, rays, gpu::kTraceAny, raysPerLane);
    std::size_t disagreements = 0;
    std::size_t blockedRays = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const bool blocked = closest[i].order != kMiss && closest[i].t < rays[i].tMax;
      if (blocked) ++blockedRays;
      if ((any[i].order != kMiss) != blocked) ++disagreements;
    }
    EXPECT_EQ(disagreements, 0U);
    EXPECT_GT(blockedRays, rays.size() / 50);
    report(grouped(disagreements) + " disagreements in " + grouped(rays.size()) + " rays, " +
           std::to_string(raysPerLane) + " together, " + grouped(blockedRays) + " of them blocked");
  }
}

}  // namespace
}  // namespace lavaray
