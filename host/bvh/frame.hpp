#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace lavaray {

// The coordinates that the shaders compute in: the camera is the origin, and a scene whose spheres and
// triangles have no coordinate of 1 or more is enlarged by a power of two, so that their largest one is in
// [1, 2), or as far as its lights and planes are not too far away for that. That changes no digit of what is
// computed, but keeps products of four lengths, which the test of spheres has, above the least number that
// every device computes with.
struct Frame {
  glm::dvec3 origin{0.0};
  double scale = 1.0;

  [[nodiscard]] glm::vec3 position(const glm::dvec3& point) const;
  [[nodiscard]] float length(double length) const;
  // Of the plane through the point, along the unit normal.
  [[nodiscard]] float planeDistance(const glm::dvec3& normal, const glm::dvec3& point) const;

  bool operator==(const Frame&) const = default;
};

Frame frameOf(const Scene& scene);

// Rounded to float32, a denormal number to 0, for which some devices take it and some not.
float toFloat(double value);
glm::vec3 toFloat(const glm::dvec3& v);

}  // namespace lavaray
