#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace lavaray {

inline double largestComponent(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

inline bool isFinite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// v at unit length; the zero vector stays zero. Scaled by its largest component first, so that neither tiny
// nor huge vectors lose their squared length.
inline glm::dvec3 unitOrZero(const glm::dvec3& v) {
  const double largest = largestComponent(v);
  return largest > 0.0 ? glm::normalize(v / largest) : glm::dvec3(0.0);
}

}  // namespace lavaray
