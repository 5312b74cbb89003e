// The traversal on the device against brute force with the same primitive tests: the same hit, bit for bit.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include <glm/geometric.hpp>

#include "bvh/flatten.hpp"
#include "device/trace_rays.hpp"
#include "scene/scene_reader.hpp"
#include "stress/report.hpp"
#include "support/scene_building.hpp"

namespace lavaray {
namespace {

struct SceneAndRays {
  Scene scene;
  std::vector<gpu::ProbeRay> rays;
};

gpu::ProbeRay rayThrough(const glm::dvec3& origin, const glm::dvec3& target) {
  return {origin, kNoSkip, glm::vec3(target) - glm::vec3(origin), INFINITY};
}

// Half of the rays run between random points, half are aimed at random points of the triangles' edges and at
// their vertices.
std::vector<gpu::ProbeRay> randomAndEdgeRays(const std::vector<Triangle>& triangles, std::size_t count,
                                             double extent, Random& random) {
  std::vector<gpu::ProbeRay> rays;
  std::uniform_real_distribution<double> along(0.0, 1.0);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 origin = randomPoint(random, extent);
    if (i % 2 == 0 || triangles.empty()) {
      rays.push_back(rayThrough(origin, randomPoint(random, extent)));
    } else {
      const auto& v = triangles[random() % triangles.size()].vertices;
      const double s = i % 4 == 1 ? along(random) : 0.0;
      rays.push_back(rayThrough(origin, v[0] + s * (v[1] - v[0])));
    }
  }
  return rays;
}

SceneAndRays triangleSoup(std::size_t rayCount) {
  Random random(1);
  SceneAndRays result;
  addRandomTriangles(result.scene, 1000, glm::dvec3(0.0), random);
  result.rays = randomAndEdgeRays(result.scene.triangles, rayCount, 12.0, random);
  return result;
}

// A sliver is missed by nearly all random rays, so all are aimed at one.
SceneAndRays slivers(std::size_t rayCount) {
  Random random(2);
  SceneAndRays result;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 a = randomPoint(random, 10.0);
    const glm::dvec3 along = randomPoint(random, 5.0);
    addTriangle(result.scene, a, a + along, a + 0.5 * along + randomPoint(random, 1e-4));
  }
  for (std::size_t i = 0; i < rayCount; ++i) {
    const auto& v = result.scene.triangles[random() % 1000].vertices;
    result.rays.push_back(rayThrough(randomPoint(random, 12.0), (v[0] + v[1] + v[2]) / 3.0));
  }
  return result;
}

SceneAndRays spheres(std::size_t rayCount) {
  Random random(3);
  SceneAndRays result;
  std::uniform_real_distribution<double> radius(0.05, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 center = randomPoint(random, 10.0);
    addSphere(result.scene, center, radius(random));
  }
  result.rays = randomAndEdgeRays({}, rayCount, 12.0, random);
  return result;
}

SceneAndRays mixture(std::size_t rayCount) {
  Random random(4);
  SceneAndRays result;
  for (int i = 0; i < 500; ++i) {
    addSphere(result.scene, randomPoint(random, 10.0), 0.5);
    addRandomTriangles(result.scene, 1, glm::dvec3(0.0), random);
  }
  result.rays = randomAndEdgeRays(result.scene.triangles, rayCount, 12.0, random);
  return result;
}

// Flat boxes, and rays along the axes whose origins lie in the planes of the boxes' sides: 0 * infinity.
SceneAndRays gridAlongTheAxes(std::size_t rayCount) {
  Random random(5);
  SceneAndRays result;
  for (int x = 0; x < 10; ++x) {
    for (int y = 0; y < 10; ++y) {
      for (int z = 0; z < 5; ++z) {
        const glm::dvec3 a(x, y, z);
        addTriangle(result.scene, a, a + glm::dvec3(1, 0, 0), a + glm::dvec3(0, 1, 0));
        addTriangle(result.scene, a + glm::dvec3(0, 1, 0), a + glm::dvec3(0, 0, 1), a + glm::dvec3(0, 1, 1));
      }
    }
  }
  std::uniform_int_distribution<int> half(-2, 24);
  for (std::size_t i = 0; i < rayCount; ++i) {
    const int x = half(random);
    const int y = half(random);
    gpu::ProbeRay ray{glm::vec3(x, y, half(random)) / 2.0F, kNoSkip, glm::vec3(0.0F), INFINITY};
    ray.direction[static_cast<int>(random() % 3)] = random() % 2 == 0 ? 1.0F : -1.0F;
    if (random() % 4 == 0) ray.direction[static_cast<int>(random() % 3)] = random() % 2 == 0 ? 1.0F : -0.0F;
    result.rays.push_back(ray);
  }
  return result;
}

void addCube(Scene& scene, const glm::dvec3& corner) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 u(0.0);
    glm::dvec3 v(0.0);
    u[(axis + 1) % 3] = 1.0;
    v[(axis + 2) % 3] = 1.0;
    for (const double side : {0.0, 1.0}) {
      glm::dvec3 a = corner;
      a[axis] += side;
      addTriangle(scene, a, a + u, a + u + v);
      addTriangle(scene, a, a + u + v, a + v);
    }
  }
}

// 0, -0, a denormal number, 1 or -1, or any number up to 1: where the inverse of a direction's component is
// infinite, or is too large for a float.
float hostileComponent(Random& random) {
  const float number = uniform(random, -1.0F, 1.0F);
  switch (random() % 5) {
    case 0:
      return 0.0F;
    case 1:
      return -0.0F;
    case 2:
      return 1e-40F * number;
    case 3:
      return number < 0.0F ? -1.0F : 1.0F;
    default:
      return number;
  }
}

glm::vec3 hostileDirection(Random& random) {
  glm::vec3 direction(0.0F);
  while (!(glm::length(direction) > 1e-3F)) {
    for (int axis = 0; axis < 3; ++axis) direction[axis] = hostileComponent(random);
  }
  return direction;
}

// Cubes in the black fields of a chess board of three dimensions, and rays to their corners and the middles
// of their edges and sides, along the sides' planes or off them by a denormal number. Some begin in a plane
// of the lattice.
SceneAndRays latticeOfCubes(std::size_t rayCount) {
  Random random(9);
  SceneAndRays result;
  for (int i = 0; i < 216; ++i) {
    const glm::ivec3 cell(i % 6, i / 6 % 6, i / 36);
    if ((cell.x + cell.y + cell.z) % 2 == 0) addCube(result.scene, cell);
  }
  for (std::size_t i = 0; i < rayCount; ++i) {
    const auto& v = result.scene.triangles[random() % result.scene.triangles.size()].vertices;
    const glm::vec3 targets[] = {v[0], 0.5 * (v[0] + v[1]), (v[0] + v[1] + v[2]) / 3.0};
    const glm::vec3 direction = hostileDirection(random);
    const auto length = static_cast<float>(1 + random() % 20);
    glm::vec3 origin = targets[random() % 3] - direction * length;
    for (int axis = 0; axis < 3; ++axis) {
      const auto plane = static_cast<float>(random() % 7);
      if (direction[axis] == 0.0F && random() % 3 == 0) origin[axis] = plane;
    }
    result.rays.push_back({origin, kNoSkip, direction, INFINITY});
  }
  return result;
}

SceneAndRays farFromTheOrigin(std::size_t rayCount) {
  Random random(6);
  SceneAndRays result;
  const glm::dvec3 far(148376.0, 1234.0, -223423.0);
  addRandomTriangles(result.scene, 1000, far, random);
  for (std::size_t i = 0; i < rayCount; ++i) {
    const auto& v = result.scene.triangles[random() % 1000].vertices;
    result.rays.push_back(rayThrough(far + randomPoint(random, 12.0), v[0] + 0.5 * (v[1] - v[0])));
  }
  return result;
}

// Triangles that come nearer to the origin in proportion, so that the tree is as deep as it may be. Seen from
// the origin, the deeper child is the nearer one at every node: the other ones fill the stack. Half of the
// rays miss all triangles and leave no box out.
SceneAndRays deepTree(std::size_t rayCount) {
  Random random(8);
  SceneAndRays result;
  for (double x = 1e15; x > 1e-9; x *= 0.99) {
    addTriangle(result.scene, {x, 0, 0}, {x, 1, 0}, {1.001 * x, 0, 1});
  }
  std::uniform_real_distribution<float> position(0.0F, 1.0F);
  for (std::size_t i = 0; i < rayCount / 50; ++i) {
    const float y = position(random);
    const glm::vec3 origin(i % 4 < 2 ? 0.0F : 2e15F, y, position(random));
    result.rays.push_back({origin, kNoSkip, glm::vec3(origin.x > 0.0F ? -1.0F : 1.0F, 0.0F, 0.0F), INFINITY});
  }
  return result;
}

SceneAndRays torusMesh(std::size_t rayCount) {
  Random random(7);
  SceneAndRays result{readScene(LAVARAY_SCENES_DIR "/torus.txt"), {}};
  const Mesh& mesh = result.scene.meshes.at(0);
  glm::dvec3 center(0.0);
  for (const glm::dvec3& p : mesh.positions) center += p / static_cast<double>(mesh.positions.size());
  double extent = 0.0;
  for (const glm::dvec3& p : mesh.positions) extent = std::max(extent, glm::distance(p, center));
  std::vector<Triangle> triangles;  // about the origin
  for (const MeshTriangle& t : mesh.triangles) {
    const auto [a, b, c] = t.positions;
    triangles.push_back(
        {{mesh.positions[a] - center, mesh.positions[b] - center, mesh.positions[c] - center}, 0});
  }
  result.rays = randomAndEdgeRays(triangles, rayCount, 1.2 * extent, random);
  // Relative to the camera, as the device has it.
  const glm::vec3 place = center - result.scene.camera.position;
  for (gpu::ProbeRay& ray : result.rays) ray.origin += place;
  return result;
}

struct Case {
  const char* name;
  SceneAndRays (*make)(std::size_t rayCount);
  // Of the rays, how many may hit another primitive than brute force, at the same distance. Where a hit is
  // near compared with the size of its triangle, rounding moves it by more than the boxes are widened by, and
  // the box of a second triangle there can seem to lie behind it.
  double mostTies = 0.0;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.name;
}

const auto kCases =
    testing::Values(Case{"TriangleSoup", triangleSoup}, Case{"Slivers", slivers}, Case{"Spheres", spheres},
                    Case{"Mixture", mixture}, Case{"GridAlongTheAxes", gridAlongTheAxes},
                    Case{"LatticeOfCubes", latticeOfCubes, 1e-4}, Case{"FarFromTheOrigin", farFromTheOrigin},
                    Case{"DeepTree", deepTree}, Case{"TorusMesh", torusMesh});
const auto kCaseName = [](const auto& test) { return std::string(test.param.name); };

class ClosestHit : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(, ClosestHit, kCases, kCaseName);

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
    // Of several at one distance both must name the first in the file, so the primitive is the same, too.
    if (expected[i].order != kMiss) ++hits;
    if (closest[i].t != expected[i].t) {
      ++wrong;
    } else if (closest[i].order != expected[i].order) {
      ++ties;
    }
  }
  EXPECT_EQ(wrong, 0U);
  EXPECT_LE(static_cast<double>(ties), GetParam().mostTies * static_cast<double>(rays.size()));
  EXPECT_GT(hits, rays.size() / 20);
  report(grouped(wrong) + " hits in " + grouped(rays.size()) + " rays differ from brute force, " +
         grouped(ties) + " name another primitive at the same distance, " + grouped(hits) +
         " rays hit one of " + grouped(gpuScene.primitives.size()) + " primitives; depth of the tree " +
         std::to_string(gpuScene.bvhQuality.depth));
}

class AnyHit : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(, AnyHit, kCases, kCaseName);

// Up to a random distance, something is hit exactly where the closest hit is nearer than that.
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
  const std::vector<gpu::ProbeHit> any = traceRays(gpuScene, rays, gpu::kTraceAny);
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
         grouped(blockedRays) + " of them blocked");
}

}  // namespace
}  // namespace lavaray
