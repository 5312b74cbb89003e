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

// v scaled to unit length; the zero vector stays zero. Divides by the largest component first, so that the
// squared length of a tiny vector does not underflow and that of a huge one does not overflow.
inline glm::dvec3 unitOrZero(const glm::dvec3& v) {
  const double largest = largestComponent(v);
  return largest > 0.0 ? glm::normalize(v / largest) : glm::dvec3(0.0);
}

}  // namespace lavaray
