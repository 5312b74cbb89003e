#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace lavaray {

// An axis-aligned box. A default-constructed one is empty, and neutral in a union.
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
  // Twice the centre: enough to compare centroids, without the rounding and the work of halving.
  [[nodiscard]] glm::vec3 doubledCentroid() const { return lower + upper; }
};

// Half the surface area; 0 for an empty box.
inline float halfArea(const Box& box) {
  const glm::vec3 size = glm::max(box.upper - box.lower, glm::vec3(0.0F));
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

}  // namespace lavaray
