#include "procedural.hpp"

#include <array>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

namespace lavaray::bench {
namespace {

// In [-1, 1). The standard's distributions differ between libraries, its generator does not.
double uniform(std::mt19937& random) {
  return static_cast<double>(random()) / 2147483648.0 - 1.0;
}

// Waves along fixed random directions, each octave half as long and half as high as the one before.
class Bumps {
 public:
  Bumps() {
    std::mt19937 random(1);
    for (std::array<Wave, kWaves>& octave : octaves_) {
      for (Wave& wave : octave) {
        const glm::dvec3 direction(uniform(random), uniform(random), uniform(random));
        wave = {glm::normalize(direction), 3.2 * uniform(random)};
      }
    }
  }

  [[nodiscard]] double at(const glm::dvec3& point) const {
    double sum = 0.0;
    double frequency = 6.0;
    double height = 0.04;
    for (const std::array<Wave, kWaves>& octave : octaves_) {
      for (const Wave& wave : octave) {
        sum += height * std::sin(frequency * glm::dot(wave.direction, point) + wave.phase);
      }
      frequency *= 2.0;
      height *= 0.5;
    }
    return sum;
  }

 private:
  struct Wave {
    glm::dvec3 direction;
    double phase;
  };
  static constexpr int kWaves = 3;
  std::array<std::array<Wave, kWaves>, 6> octaves_;
};

// The tangent makes the cells of the ball about equal. 1 stays exactly 1, so that the faces meet.
double onCube(double u) {
  return std::abs(u) == 1.0 ? u : std::tan(std::atan(1.0) * u);
}

// The point at (u, v) in [-1, 1]^2 of a face of the cube, moved onto the ball.
glm::dvec3 onUnitBall(int face, double u, double v) {
  const double x = onCube(u);
  const double y = onCube(v);
  const std::array<glm::dvec3, 6> points{
      {{x, y, 1}, {y, x, -1}, {1, x, y}, {-1, y, x}, {y, 1, x}, {x, -1, y}}};
  return glm::normalize(points[face]);
}

}  // namespace

Mesh bumpyBall(std::size_t triangles) {
  constexpr std::size_t kTrianglesPerCell = 12;  // two on each of six faces
  const auto side = static_cast<std::uint32_t>(
      std::lround(std::sqrt(static_cast<double>(triangles) / static_cast<double>(kTrianglesPerCell))));
  const Bumps bumps;
  Mesh mesh;
  mesh.file = "bumpy ball";
  for (int face = 0; face < 6; ++face) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t row = 0; row <= side; ++row) {
      for (std::uint32_t column = 0; column <= side; ++column) {
        const glm::dvec3 point = onUnitBall(face, 2.0 * column / side - 1.0, 2.0 * row / side - 1.0);
        mesh.positions.push_back((1.0 + bumps.at(point)) * point);
      }
    }
    for (std::uint32_t row = 0; row < side; ++row) {
      for (std::uint32_t column = 0; column < side; ++column) {
        const std::uint32_t a = first + row * (side + 1) + column;
        const std::uint32_t c = a + side + 1;
        mesh.triangles.push_back({{a, a + 1, c + 1}});
        mesh.triangles.push_back({{a, c + 1, c}});
      }
    }
  }
  return mesh;
}

std::vector<Sphere> sphereCloud(std::size_t count) {
  std::mt19937 random(2);
  const auto side = static_cast<int>(std::lround(std::cbrt(static_cast<double>(count))));
  const double cell = 2.0 / side;
  std::vector<Sphere> spheres;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) {
        const double radius = cell * (0.25 + 0.1 * uniform(random));
        const double room = 0.5 * cell - radius;
        const glm::dvec3 offset(uniform(random), uniform(random), uniform(random));
        const glm::dvec3 center = -1.0 + cell * (0.5 + glm::dvec3(x, y, z)) + room * offset;
        spheres.push_back({center, radius, static_cast<std::uint32_t>(spheres.size())});
      }
    }
  }
  return spheres;
}

}  // namespace lavaray::bench
