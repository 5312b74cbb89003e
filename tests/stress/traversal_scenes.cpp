#include "stress/traversal_scenes.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "scene/scene_reader.hpp"
#include "support/scene_building.hpp"

namespace lavaray {
namespace {

gpu::ProbeRay rayThrough(const glm::dvec3& origin, const glm::dvec3& target) {
  return {origin, kNoSkip, glm::vec3(target) - glm::vec3(origin), INFINITY};
}

// Half of the rays run between random points; the others are aimed at points on the triangles' edges, and at
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

// Nearly every random ray misses a sliver, so each ray is aimed at one.
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

// Flat boxes, and rays along the axes whose origins lie in the planes of the boxes' faces: 0 * infinity.
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

// 0, -0, a denormal number, 1 or -1, or any number up to 1: the inverse of some is infinite or too large for
// a float.
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

// Cubes on the black cells of a three-dimensional chessboard, and rays to their corners and to the middles of
// their edges and faces, in the planes of the faces or off them by a denormal number. Some start in a plane
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

// Triangles at geometrically shrinking distances from the origin, so that the tree is as deep as it may be.
// Seen from the origin, the deeper child of every node is the nearer one, so the others fill the stack. Half
// of the rays miss all triangles but skip no box.
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
  // Relative to the camera, as on the device.
  const glm::vec3 place = center - result.scene.camera.position;
  for (gpu::ProbeRay& ray : result.rays) ray.origin += place;
  return result;
}

}  // namespace

std::vector<TraversalScene> traversalScenes() {
  return {{"TriangleSoup", triangleSoup},
          {"Slivers", slivers},
          {"Spheres", spheres},
          {"Mixture", mixture},
          {"GridAlongTheAxes", gridAlongTheAxes},
          {"LatticeOfCubes", latticeOfCubes},
          {"FarFromTheOrigin", farFromTheOrigin},
          {"DeepTree", deepTree},
          {"TorusMesh", torusMesh}};
}

std::ostream& operator<<(std::ostream& out, const TraversalScene& scene) {
  return out << scene.name;
}

std::string traversalSceneName(const testing::TestParamInfo<TraversalScene>& test) {
  return test.param.name;
}

}  // namespace lavaray
