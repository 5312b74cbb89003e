#pragma once

#include <random>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace lavaray {

// What tests draw by chance; the same from the same seed as long as no expression draws twice: compilers
// differ in which of its parts they evaluate first.

using Random = std::mt19937;

template <typename Number>
Number uniform(Random& random, Number from, Number to) {
  return std::uniform_real_distribution<Number>(from, to)(random);
}

// Each coordinate in +-extent.
inline glm::dvec3 randomPoint(Random& random, double extent) {
  std::uniform_real_distribution<double> coordinate(-extent, extent);
  const double x = coordinate(random);
  const double y = coordinate(random);
  return {x, y, coordinate(random)};
}

// Of unit length, uniformly distributed.
inline glm::dvec3 randomDirection(Random& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random);
  const double y = normal(random);
  return glm::normalize(glm::dvec3(x, y, normal(random)));
}

}  // namespace lavaray
