// The traversal on the device against brute force with the same primitive tests: the same hit, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

#include "core/flatten.hpp"
#include "gpu/test_device.hpp"
#include "render/scene_buffers.hpp"
#include "shaders/probe.h"
#include "traceProbeSpirv.spv.h"
#include "vulkan/compute.hpp"

namespace lavaray {
namespace {

constexpr std::uint32_t kMiss = 0xFFFFFFFF;
constexpr std::uint32_t kNoSkip = 0xFFFFFFFF;

class Tracer {
 public:
  explicit Tracer(const Scene& scene) : scene_(flatten(scene, 2)) {}

  std::vector<gpu::ProbeHit> trace(const std::vector<gpu::ProbeRay>& rays, gpu::uint mode) {
    vulkan::Device& device = testDevice();
    std::vector<vulkan::Buffer> buffers = uploadScene(device, scene_);
    buffers.push_back(vulkan::Buffer::shared(device, "rays", rays.size() * sizeof(gpu::ProbeRay)));
    buffers.push_back(vulkan::Buffer::shared(device, "hits", rays.size() * sizeof(gpu::ProbeHit)));
    std::memcpy(buffers[gpu::kBindingProbeIn].bytes(), rays.data(), rays.size() * sizeof(gpu::ProbeRay));
    const gpu::TraceConstants constants{static_cast<gpu::uint>(rays.size()),
                                        static_cast<gpu::uint>(scene_.primitives.size()), mode, 0};
    vulkan::ComputeShader shader(device, traceProbeSpirv, specializationFor(scene_), buffers,
                                 sizeof constants);
    const auto groups =
        static_cast<std::uint32_t>((rays.size() + gpu::kWorkGroupSize - 1) / gpu::kWorkGroupSize);
    shader.dispatch(groups, std::as_bytes(std::span(&constants, 1)));
    std::vector<gpu::ProbeHit> hits(rays.size());
    std::memcpy(hits.data(), buffers[gpu::kBindingProbeOut].bytes(), hits.size() * sizeof(gpu::ProbeHit));
    return hits;
  }

 private:
  GpuScene scene_;
};

using Random = std::mt19937;

glm::dvec3 randomPoint(Random& random, double extent) {
  std::uniform_real_distribution<double> coordinate(-extent, extent);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

gpu::ProbeRay rayThrough(const glm::dvec3& origin, const glm::dvec3& target) {
  return {origin, kNoSkip, glm::vec3(target) - glm::vec3(origin), INFINITY};
}

void addTriangle(Scene& scene, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  scene.triangles.push_back({{a, b, c}, static_cast<std::uint32_t>(scene.materials.size())});
  scene.materials.emplace_back();
}

void addSphere(Scene& scene, const glm::dvec3& center, double radius) {
  scene.spheres.push_back({center, radius, static_cast<std::uint32_t>(scene.materials.size())});
  scene.materials.emplace_back();
}

void addRandomTriangles(Scene& scene, int count, const glm::dvec3& place, Random& random) {
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 a = place + randomPoint(random, 10.0);
    addTriangle(scene, a, a + randomPoint(random, 2.0), a + randomPoint(random, 2.0));
  }
}

// A closed sphere of 2 * rings * rings triangles about the origin, bumpy by up to `bump` of the radius.
std::vector<std::vector<glm::dvec3>> sphereGrid(int rings, double bump, Random& random) {
  std::uniform_real_distribution<double> radius(1.0 - bump, 1.0 + bump);
  std::vector<std::vector<glm::dvec3>> grid(rings + 1, std::vector<glm::dvec3>(rings));
  const double north = radius(random);
  const double south = radius(random);
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j < rings; ++j) {
      const double theta = std::numbers::pi * i / rings;
      const double phi = 2.0 * std::numbers::pi * j / rings;
      const double r = i == 0 ? north : (i == rings ? south : radius(random));
      const double ringRadius = i == 0 || i == rings ? 0.0 : std::sin(theta);
      grid[i][j] = r * glm::dvec3(ringRadius * std::cos(phi), std::cos(theta), ringRadius * std::sin(phi));
    }
  }
  return grid;
}

void addGrid(Scene& scene, const std::vector<std::vector<glm::dvec3>>& grid) {
  const std::size_t rings = grid.size() - 1;
  for (std::size_t i = 0; i < rings; ++i) {
    for (std::size_t j = 0; j < rings; ++j) {
      const std::size_t k = (j + 1) % rings;
      if (i > 0) addTriangle(scene, grid[i][j], grid[i][k], grid[i + 1][j]);
      if (i + 1 < rings) addTriangle(scene, grid[i][k], grid[i + 1][k], grid[i + 1][j]);
    }
  }
}

// Half of the rays run between random points, half are aimed at random points of the triangles' edges and at
// their vertices.
std::vector<gpu::ProbeRay> randomAndEdgeRays(const Scene& scene, std::size_t count, double extent,
                                             Random& random) {
  std::vector<gpu::ProbeRay> rays;
  std::uniform_real_distribution<double> along(0.0, 1.0);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 origin = randomPoint(random, extent);
    if (i % 2 == 0 || scene.triangles.empty()) {
      rays.push_back(rayThrough(origin, randomPoint(random, extent)));
    } else {
      const auto& v = scene.triangles[random() % scene.triangles.size()].vertices;
      const double s = i % 4 == 1 ? along(random) : 0.0;
      rays.push_back(rayThrough(origin, v[0] + s * (v[1] - v[0])));
    }
  }
  return rays;
}

void expectBvhEqualsBruteForce(const Scene& scene, std::vector<gpu::ProbeRay> rays) {
  Tracer tracer(scene);
  const std::vector<gpu::ProbeHit> closest = tracer.trace(rays, gpu::kTraceClosest);
  const std::vector<gpu::ProbeHit> expected = tracer.trace(rays, gpu::kTraceBruteForce);
  std::size_t hits = 0;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(closest[i].finished, 1U);
    ASSERT_EQ(expected[i].finished, 1U);
    const bool same = closest[i].t == expected[i].t && closest[i].order == expected[i].order;
    if (expected[i].order != kMiss) ++hits;
    if (!same) ++wrong;
  }
  EXPECT_EQ(wrong, 0U) << "of " << rays.size() << " rays";
  EXPECT_GT(hits, rays.size() / 20);
  EXPECT_LT(hits, rays.size() + 1);

  // Any-hit up to a random distance says the same as the closest hit does.
  Random random(99);
  std::uniform_real_distribution<float> factor(0.3F, 1.7F);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    rays[i].tMax = expected[i].order == kMiss ? 1.0F : expected[i].t * factor(random);
  }
  const std::vector<gpu::ProbeHit> any = tracer.trace(rays, gpu::kTraceAny);
  std::size_t disagreements = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool blocked = expected[i].order != kMiss && expected[i].t < rays[i].tMax;
    if ((any[i].order != kMiss) != blocked) ++disagreements;
  }
  EXPECT_EQ(disagreements, 0U) << "of " << rays.size() << " rays";
  std::cout << wrong << " wrong closest hits, " << disagreements << " wrong any-hits in " << rays.size()
            << " rays, " << hits << " of which hit\n";
}

constexpr std::size_t kRays = 100000;

TEST(Traversal, EqualsBruteForceInATriangleSoup) {
  Random random(1);
  Scene scene;
  addRandomTriangles(scene, 1000, glm::dvec3(0.0), random);
  expectBvhEqualsBruteForce(scene, randomAndEdgeRays(scene, kRays, 12.0, random));
}

TEST(Traversal, EqualsBruteForceAmongSlivers) {
  Random random(2);
  Scene scene;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 a = randomPoint(random, 10.0);
    const glm::dvec3 along = randomPoint(random, 5.0);
    addTriangle(scene, a, a + along, a + 0.5 * along + randomPoint(random, 1e-4));
  }
  // A sliver is missed by nearly all random rays, so all are aimed at one.
  std::vector<gpu::ProbeRay> rays;
  for (std::size_t i = 0; i < kRays; ++i) {
    const auto& v = scene.triangles[random() % scene.triangles.size()].vertices;
    rays.push_back(rayThrough(randomPoint(random, 12.0), (v[0] + v[1] + v[2]) / 3.0));
  }
  expectBvhEqualsBruteForce(scene, rays);
}

TEST(Traversal, EqualsBruteForceAmongSpheres) {
  Random random(3);
  Scene scene;
  std::uniform_real_distribution<double> radius(0.05, 1.0);
  for (int i = 0; i < 1000; ++i) addSphere(scene, randomPoint(random, 10.0), radius(random));
  expectBvhEqualsBruteForce(scene, randomAndEdgeRays(scene, kRays, 12.0, random));
}

TEST(Traversal, EqualsBruteForceInAMixture) {
  Random random(4);
  Scene scene;
  for (int i = 0; i < 500; ++i) {
    addSphere(scene, randomPoint(random, 10.0), 0.5);
    addRandomTriangles(scene, 1, glm::dvec3(0.0), random);
  }
  expectBvhEqualsBruteForce(scene, randomAndEdgeRays(scene, kRays, 12.0, random));
}

// Flat boxes, and rays along the axes whose origins lie in the planes of the boxes' sides: 0 * infinity.
TEST(Traversal, EqualsBruteForceOnAGridWithAxisParallelRays) {
  Random random(5);
  Scene scene;
  for (int x = 0; x < 10; ++x) {
    for (int y = 0; y < 10; ++y) {
      for (int z = 0; z < 5; ++z) {
        const glm::dvec3 a(x, y, z);
        addTriangle(scene, a, a + glm::dvec3(1, 0, 0), a + glm::dvec3(0, 1, 0));
        addTriangle(scene, a + glm::dvec3(0, 1, 0), a + glm::dvec3(0, 0, 1), a + glm::dvec3(0, 1, 1));
      }
    }
  }
  std::vector<gpu::ProbeRay> rays;
  std::uniform_int_distribution<int> half(-2, 24);
  for (std::size_t i = 0; i < kRays; ++i) {
    gpu::ProbeRay ray{glm::vec3(half(random), half(random), half(random)) / 2.0F, kNoSkip, glm::vec3(0.0F),
                      INFINITY};
    ray.direction[static_cast<int>(random() % 3)] = random() % 2 == 0 ? 1.0F : -1.0F;
    if (random() % 4 == 0) ray.direction[static_cast<int>(random() % 3)] = random() % 2 == 0 ? 1.0F : -0.0F;
    rays.push_back(ray);
  }
  expectBvhEqualsBruteForce(scene, rays);
}

TEST(Traversal, EqualsBruteForceFarFromTheOrigin) {
  Random random(6);
  Scene scene;
  const glm::dvec3 far(148376.0, 1234.0, -223423.0);
  addRandomTriangles(scene, 1000, far, random);
  std::vector<gpu::ProbeRay> rays = randomAndEdgeRays(scene, kRays, 12.0, random);
  for (gpu::ProbeRay& ray : rays) {
    ray.origin += glm::vec3(far);
    const auto& v = scene.triangles[random() % scene.triangles.size()].vertices;
    ray.direction = glm::vec3(v[0] + 0.5 * (v[1] - v[0])) - ray.origin;
  }
  expectBvhEqualsBruteForce(scene, rays);
}

// No ray from inside a closed mesh gets out, be it aimed at an edge or at a vertex.
TEST(Traversal, FindsNoLeakInAClosedMesh) {
  for (const glm::dvec3& place :
       {glm::dvec3(0.0), glm::dvec3(1000.0), glm::dvec3(148376.0, 1234.0, -223423.0)}) {
    Random random(7);
    auto grid = sphereGrid(64, 0.1, random);
    for (auto& ring : grid) {
      // The far placement needs a mesh that float32 can still show there.
      for (glm::dvec3& point : ring) point = glm::dvec3(glm::vec3(place + 100.0 * point));
    }
    Scene scene;
    addGrid(scene, grid);
    std::vector<gpu::ProbeRay> rays;
    std::uniform_real_distribution<double> along(0.0, 1.0);
    for (std::size_t i = 0; i < kRays; ++i) {
      const glm::dvec3 origin = place + randomPoint(random, 30.0);
      const auto& v = scene.triangles[random() % scene.triangles.size()].vertices;
      rays.push_back(rayThrough(origin, i % 2 == 0 ? v[0] + along(random) * (v[1] - v[0]) : v[2]));
    }
    const std::vector<gpu::ProbeHit> hits = Tracer(scene).trace(rays, gpu::kTraceClosest);
    const auto leaks =
        std::count_if(hits.begin(), hits.end(), [](const auto& hit) { return hit.order == kMiss; });
    EXPECT_EQ(leaks, 0);
    std::cout << leaks << " leaks in " << rays.size() << " rays\n";
  }
}

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
    std::uniform_real_distribution<double> offset(-0.2, 0.2);
    rays.push_back(rayThrough({0, 0, 0}, {offset(random), (i % 2 == 0 ? 0.0 : 3.0) + offset(random), -5}));
  }
  const std::vector<gpu::ProbeHit> hits = Tracer(scene).trace(rays, gpu::kTraceClosest);
  for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_EQ(hits[i].order, i % 2 == 0 ? 0U : 1U);
}

// A ray that passes through more boxes than the device has loop turns for is reported, never cut short.
TEST(Traversal, SaysWhenTheDeviceEndsItsLoops) {
  for (const int count : {1000, 60000}) {
    Scene scene;
    for (int i = 0; i < count; ++i) {
      const double z = -10.0 - 0.001 * i;
      addTriangle(scene, {0, 0, z}, {1, 0, z}, {0, 1, z});
    }
    // Beyond the hypotenuse, but within every box.
    const std::vector<gpu::ProbeRay> rays(64,
                                          gpu::ProbeRay{{0.9F, 0.9F, 0.0F}, kNoSkip, {0, 0, -1}, INFINITY});
    for (const gpu::ProbeHit& hit : Tracer(scene).trace(rays, gpu::kTraceClosest)) {
      EXPECT_EQ(hit.order, kMiss);
      EXPECT_EQ(hit.finished, count == 1000 ? 1U : 0U);
    }
  }
}

}  // namespace
}  // namespace lavaray
