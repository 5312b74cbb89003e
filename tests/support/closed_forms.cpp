#include "support/closed_forms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace lavaray {

// The solid angle of the part beyond is 2 (acos(sin b / sin a) - cos a acos(tan b / tan a)).
// Mazonka, "Solid Angle of Conical Surfaces, Polyhedral Cones, and Intersecting Spherical Caps", 2012.
double capBeyond(double a, double b) {
  if (b >= a) return 0.0;
  if (b <= -a) return 1.0;
  return (std::acos(std::sin(b) / std::sin(a)) - std::cos(a) * std::acos(std::tan(b) / std::tan(a))) /
         (std::numbers::pi * (1.0 - std::cos(a)));
}

// Midpoint rule over circles about the axis of the first cone. A circle at the angle t lies in the second
// cone for azimuths p with cos t cos between + sin t sin between cos p >= cos b. Written with the sines of
// half angles, which keep their digits where the angles are small, that is
// cos p >= 1 - 2 (sin^2(b / 2) - sin^2((t - between) / 2)) / (sin t sin between).
double capWithin(double a, double b, double between) {
  if (between >= a + b) return 0.0;
  if (between + a <= b) return 1.0;
  constexpr int kCircles = 500;
  const auto squaredHalfSine = [](double angle) { return std::pow(std::sin(angle / 2.0), 2.0); };
  double inside = 0.0;
  double all = 0.0;
  for (int i = 0; i < kCircles; ++i) {
    const double t = a * (i + 0.5) / kCircles;
    const double versine =
        2.0 * (squaredHalfSine(b) - squaredHalfSine(t - between)) / (std::sin(t) * std::sin(between));
    const double azimuth = std::acos(std::clamp(1.0 - versine, -1.0, 1.0));
    inside += std::sin(t) * azimuth / std::numbers::pi;
    all += std::sin(t);
  }
  return inside / all;
}

// Based on: Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974, and the shoelace formula.
double halfPlaneCoverage(double x, double y, double normalX, double normalY, double distance) {
  const std::array<glm::dvec2, 4> square = {{{x, y}, {x + 1.0, y}, {x + 1.0, y + 1.0}, {x, y + 1.0}}};
  const auto height = [&](const glm::dvec2& p) { return normalX * p.x + normalY * p.y - distance; };
  std::vector<glm::dvec2> clipped;
  for (std::size_t i = 0; i < square.size(); ++i) {
    const glm::dvec2& from = square[i];
    const glm::dvec2& to = square[(i + 1) % square.size()];
    if (height(from) >= 0.0) clipped.push_back(from);
    if ((height(from) >= 0.0) != (height(to) >= 0.0)) {
      clipped.push_back(from + (to - from) * (height(from) / (height(from) - height(to))));
    }
  }
  double twiceArea = 0.0;
  for (std::size_t i = 0; i < clipped.size(); ++i) {
    const glm::dvec2& p = clipped[i];
    const glm::dvec2& q = clipped[(i + 1) % clipped.size()];
    twiceArea += p.x * q.y - p.y * q.x;
  }
  return twiceArea / 2.0;
}

}  // namespace lavaray
