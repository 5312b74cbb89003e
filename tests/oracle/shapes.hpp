#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <limits>

#include <glm/vec3.hpp>

namespace lavaray::oracle {

// The three kinds of surfaces in double precision, relative to the camera, and what a ray tracer asks of
// each.

// Relative distance below which a point counts as lying on a surface. Rounding in double moves a computed
// point by about 1e-16 of its coordinates; slivers amplify that. Without this tolerance a face would be
// shadowed by its coincident twin, or a point on the common edge of two faces by the neighbour.
inline constexpr double kOnSurface = 1e-11;

// Surfaces are at the same distance when they differ by no more than this part of it.
inline constexpr double kSameDistance = 1e-9;

// Relative error of a position that a careful float32 renderer may make: a few units of 2^-24.
inline constexpr double kFloatError = 5e-7;

inline constexpr std::uint32_t kNoSurface = 0xFFFFFFFF;
inline constexpr double kMiss = std::numeric_limits<double>::infinity();

// What all three kinds share: the object of the scene, and the position within it (the triangle of a mesh).
struct Identity {
  std::uint32_t object = 0;
  std::uint32_t part = 0;
  auto operator<=>(const Identity&) const = default;
};

struct FlatPlane {
  glm::dvec3 point, normal;  // normal of length 1
  Identity identity;
};

struct Ball {
  glm::dvec3 center;
  double radius;
  Identity identity;
};

// A triangle of its own or of a mesh.
struct Facet {
  std::array<glm::dvec3, 3> corners;
  glm::dvec3 normal;  // of length 1, (c1 - c0) x (c2 - c0)
  bool smooth;        // has a normal at each corner
  std::array<glm::dvec3, 3> cornerNormals;
  Identity identity;
};

struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;                // of length 1
  std::uint32_t surface = kNoSurface;  // on which it starts, and which it therefore cannot meet
};

// Distance at which the ray meets the surface, or kMiss. A ray that starts on a surface does not meet it.
double distanceTo(const FlatPlane& plane, const Ray& ray);
double distanceTo(const Ball& ball, const Ray& ray);
double distanceTo(const Facet& facet, const Ray& ray);

// `certain` is false where a float32 renderer could decide otherwise.
struct Occlusion {
  bool blocked = false;
  bool certain = true;
};

// Does the surface lie between the start of the ray and the light that the ray leads to?
Occlusion occludes(const FlatPlane& plane, const Ray& ray, const glm::dvec3& light);
Occlusion occludes(const Ball& ball, const Ray& ray, const glm::dvec3& light);
Occlusion occludes(const Facet& facet, const Ray& ray, const glm::dvec3& light);

// The surface's normal for shading at the point, of length 1, turned as the format asks for one who looks
// along `direction`.
struct Normal {
  glm::dvec3 direction;
  bool certain = true;
};
Normal shadingNormal(const FlatPlane& plane, const glm::dvec3& direction);
Normal shadingNormal(const Ball& ball, const glm::dvec3& point);
Normal shadingNormal(const Facet& facet, const glm::dvec3& point, const glm::dvec3& direction);

// Largest coordinate, the measure of the rounding error that positions carry.
double magnitude(const glm::dvec3& v);

}  // namespace lavaray::oracle
