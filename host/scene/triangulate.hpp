#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lavaray {

// Whether the cross product of two edges is non-zero in double precision, whatever the triangle's size.
bool hasArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

// Splits polygons into triangles. A class so that many polygons share one allocation of working memory.
class Triangulator {
 public:
  // Indices into the polygon.
  using Corners = std::array<std::uint32_t, 3>;

  // Splits a polygon of at least 3 corners, convex or not, into triangles of the same winding: at most
  // (corners - 2), fewer if corners coincide or are collinear, none if the polygon has no area. A convex
  // polygon becomes the fan around its first corner. One that is not flat is split like its projection onto
  // the axis plane that it faces most. One that crosses itself still gives triangles, but which ones is
  // unspecified. The result is valid until the next call.
  const std::vector<Corners>& triangulate(std::span<const glm::dvec3> polygon);

 private:
  bool project(std::span<const glm::dvec3> polygon);
  void link();
  [[nodiscard]] double twiceAreaAt(std::uint32_t corner) const;
  void classifyAll();
  void classify(std::uint32_t corner);
  bool isBlocked(std::uint32_t corner);
  void clip(std::uint32_t corner);
  bool clipEars();
  [[nodiscard]] std::uint32_t fallbackCorner() const;

  std::vector<glm::dvec3> relative_;
  std::vector<glm::dvec2> points_;
  // What is left of the polygon, as a ring.
  std::vector<std::uint32_t> previous_;
  std::vector<std::uint32_t> next_;
  std::uint32_t first_ = 0;
  std::uint32_t left_ = 0;

  enum class Shape : std::uint8_t { kEar, kConvex, kNotConvex, kClipped };
  std::vector<Shape> shapes_;
  std::vector<std::uint32_t> notConvex_;  // all such corners, and some that no longer are

  std::vector<Corners> triangles_;
};

}  // namespace lavaray
