#pragma once

#include <glm/vec3.hpp>

namespace lavaray {

// Three unit vectors at right angles.
struct Frame {
  glm::dvec3 x{1, 0, 0};
  glm::dvec3 y{0, 1, 0};
  glm::dvec3 z{0, 0, 1};

  [[nodiscard]] glm::dvec3 at(const glm::dvec3& v) const { return v.x * x + v.y * y + v.z * z; }
};

}  // namespace lavaray
