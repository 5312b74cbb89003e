#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace lavaray {

// Axis-aligned box; empty (and neutral in a union) as constructed.
struct Box {
  glm::vec3 lower{std::numeric_limits<float>::infinity()};
  glm::vec3 upper{-std::numeric_limits<float>::infinity()};

  void extend(const glm::vec3& point) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  void extend(const Box& box) {
    lower = glm::min(lower, box.lower);
    upper = glm::max(upper, box.upper);
  }
  // Twice the centre: what centroid comparisons need, without the rounding and the work of halving.
  [[nodiscard]] glm::vec3 doubledCentroid() const { return lower + upper; }
};

// Half of the surface area; 0 for an empty box.
inline float halfArea(const Box& box) {
  const glm::vec3 size = glm::max(box.upper - box.lower, glm::vec3(0.0F));
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

}  // namespace lavaray
