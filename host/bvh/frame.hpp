#pragma once

#include <cmath>
#include <limits>

#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace lavaray {

// Rounded to float32; denormals become 0, since some devices flush them and some do not.
inline float toFloat(double value) {
  const auto rounded = static_cast<float>(value);
  return std::abs(rounded) < std::numeric_limits<float>::min() ? 0.0F : rounded;
}
inline glm::vec3 toFloat(const glm::dvec3& v) {
  return {toFloat(v.x), toFloat(v.y), toFloat(v.z)};
}

// The coordinates in which the shaders compute. The camera is the origin. A scene whose spheres and triangles
// have no coordinate of 1 or more is enlarged by a power of two until their largest one is in [1, 2), or less
// if that would take its lights and planes too far away. Scaling changes no digit of what is computed, but
// keeps products of four lengths, which the sphere test needs, above the smallest number that every device
// can compute with.
struct Frame {
  glm::dvec3 origin{0.0};
  double scale = 1.0;

  [[nodiscard]] glm::vec3 position(const glm::dvec3& point) const {
    return toFloat(scale * (point - origin));
  }
  [[nodiscard]] float length(double length) const { return toFloat(scale * length); }
  // Distance of the plane through the point, along its unit normal.
  [[nodiscard]] float planeDistance(const glm::dvec3& normal, const glm::dvec3& point) const;

  bool operator==(const Frame&) const = default;
};

Frame frameOf(const Scene& scene);

}  // namespace lavaray
