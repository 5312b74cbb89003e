#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace lavaray::oracle {

// What the oracle needs to take random samples and to say how far their mean may be off.

using Random = std::mt19937_64;

// The same numbers for a pixel in whatever order pixels are rendered, and wherever a crop begins.
inline Random pixelRandom(std::uint64_t seed, int x, int y) {
  std::seed_seq sequence{seed & 0xFFFFFFFF, seed >> 32, static_cast<std::uint64_t>(x),
                         static_cast<std::uint64_t>(y)};
  return Random(sequence);
}

// In [0, 1), in steps of 2^-53.
inline double uniform(Random& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

// The point of the light's sphere in a direction drawn uniformly from all those in which `position` sees the
// sphere: the near intersection for a position outside, the only one for a position inside.
// Shirley, Wang, Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", 1996.
inline glm::dvec3 pointOnLight(const glm::dvec3& position, const glm::dvec3& center, double radius,
                               Random& random) {
  const glm::dvec3 toCenter = center - position;
  const double distance = glm::length(toCenter);
  const bool inside = distance <= radius;
  const glm::dvec3 axis = distance > 0.0 ? toCenter / distance : glm::dvec3(0.0, 0.0, 1.0);
  // 1 - cosine of the cone's angle. As the difference it would lose the digits of small angles.
  const double sine = inside ? 1.0 : radius / distance;
  const double coneHeight = inside ? 2.0 : sine * sine / (1.0 + std::sqrt((1.0 - sine) * (1.0 + sine)));

  const double height = uniform(random) * coneHeight;
  const double azimuth = uniform(random) * 2.0 * std::numbers::pi;
  const double cosine = 1.0 - height;
  const double off = std::sqrt(height * (2.0 - height));
  // Any direction that is not nearly parallel to the axis starts the frame.
  const glm::dvec3 other = std::abs(axis.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(axis, other));
  const glm::dvec3 v = glm::cross(axis, u);
  const glm::dvec3 direction = cosine * axis + off * (std::cos(azimuth) * u + std::sin(azimuth) * v);

  const double halfChordSquared = radius * radius - distance * distance * off * off;
  const double halfChord = std::sqrt(std::max(halfChordSquared, 0.0));
  return position + (distance * cosine + (inside ? halfChord : -halfChord)) * direction;
}

// Mean and variance in one pass: Welford, "Note on a Method for Calculating Corrected Sums of Squares and
// Products", 1962.
class Mean {
 public:
  void add(const glm::dvec3& value) {
    ++count_;
    const glm::dvec3 step = value - mean_;
    mean_ += step / count_;
    squares_ += step * (value - mean_);
  }

  [[nodiscard]] const glm::dvec3& value() const { return mean_; }

  // The samples' standard deviation over the root of their number; needs two samples or more.
  [[nodiscard]] glm::dvec3 standardError() const {
    const glm::dvec3 variance = squares_ / ((count_ - 1.0) * count_);
    return {std::sqrt(variance.x), std::sqrt(variance.y), std::sqrt(variance.z)};
  }

 private:
  double count_ = 0.0;
  glm::dvec3 mean_{0.0};
  glm::dvec3 squares_{0.0};
};

}  // namespace lavaray::oracle
