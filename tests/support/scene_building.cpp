#include "support/scene_building.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace lavaray {
namespace {

std::uint32_t addObject(Scene& scene) {
  scene.materials.emplace_back();
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

}  // namespace

void addTriangle(Scene& scene, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  scene.triangles.push_back({{a, b, c}, addObject(scene)});
}

void addSphere(Scene& scene, const glm::dvec3& center, double radius) {
  scene.spheres.push_back({center, radius, addObject(scene)});
}

void addPlane(Scene& scene, const glm::dvec3& normal, const glm::dvec3& point) {
  scene.planes.push_back({normal, point, addObject(scene)});
}

void addRandomTriangles(Scene& scene, int count, const glm::dvec3& place, Random& random) {
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 a = place + randomPoint(random, 10.0);
    const glm::dvec3 b = a + randomPoint(random, 2.0);
    addTriangle(scene, a, b, a + randomPoint(random, 2.0));
  }
}

Grid sphereGrid(int rings, double bump, Random& random) {
  std::uniform_real_distribution<double> radius(1.0 - bump, 1.0 + bump);
  Grid grid(rings + 1, std::vector<glm::dvec3>(rings));
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

void addGrid(Scene& scene, const Grid& grid, Random& random) {
  const auto add = [&](const std::array<glm::dvec3, 3>& v) {
    const std::size_t first = random() % 3;
    addTriangle(scene, v[first], v[(first + 1) % 3], v[(first + 2) % 3]);
  };
  const std::size_t rings = grid.size() - 1;
  for (std::size_t i = 0; i < rings; ++i) {
    for (std::size_t j = 0; j < rings; ++j) {
      const std::size_t k = (j + 1) % rings;
      if (i > 0) add({grid[i][j], grid[i][k], grid[i + 1][j]});
      if (i + 1 < rings) add({grid[i][k], grid[i + 1][k], grid[i + 1][j]});
    }
  }
}

}  // namespace lavaray
