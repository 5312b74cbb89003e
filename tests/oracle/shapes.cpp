#include "oracle/shapes.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace lavaray::oracle {
namespace {

using glm::dvec3;

bool startsOn(double distanceToSurface, double scale) {
  return std::abs(distanceToSurface) <= kOnSurface * scale;
}

// How a line passes an edge: the volume spanned by the line's direction and the edge's ends, positive on the
// inner side. Two facets that share an edge get values of exactly opposite sign, so no line slips between.
struct EdgePass {
  double volume;     // = distance between the two lines * spread
  double spread;     // length of direction x edge
  double tolerance;  // rounding error of `volume`, so that a line through a corner cannot miss a whole fan
};

std::array<EdgePass, 3> passEdges(const Facet& facet, const dvec3& origin, const dvec3& direction) {
  constexpr double kRounding = 1e-15;
  const double side = glm::dot(facet.normal, direction) < 0.0 ? -1.0 : 1.0;
  std::array<EdgePass, 3> passes{};
  for (std::size_t k = 0; k < 3; ++k) {
    const dvec3 from = facet.corners[k] - origin;
    const dvec3 to = facet.corners[(k + 1) % 3] - origin;
    passes[k] = {side * glm::dot(direction, glm::cross(from, to)),
                 glm::length(glm::cross(direction, to - from)),
                 kRounding * glm::length(from) * glm::length(to)};
  }
  return passes;
}

// The segment against a plane through `point`: blocked where its ends lie on different sides. An end in the
// plane is not crossed: a surface does not block a point of its own, nor a light that it passes through.
Occlusion crossesPlane(const dvec3& point, const dvec3& normal, const dvec3& from, const dvec3& light) {
  const double atStart = glm::dot(normal, from - point);
  const double atLight = glm::dot(normal, light - point);
  const double startScale = magnitude(from) + magnitude(point);
  const double lightScale = magnitude(light) + magnitude(point);
  if (startsOn(atStart, startScale) || startsOn(atLight, lightScale)) return {};
  const bool certain =
      std::abs(atStart) > kFloatError * startScale && std::abs(atLight) > kFloatError * lightScale;
  return {(atStart < 0.0) != (atLight < 0.0), certain};
}

// How far a float32 renderer may be off where the ray passes the occluder: an error of the light's position
// counts by the part of the way to the light that lies before the occluder.
double passingError(const dvec3& from, const dvec3& light, const dvec3& occluder, double part) {
  return kFloatError *
         (magnitude(from) + magnitude(occluder) + std::clamp(part, 0.0, 1.0) * magnitude(light));
}

}  // namespace

double magnitude(const dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double distanceTo(const FlatPlane& plane, const Ray& ray) {
  const double height = glm::dot(plane.normal, plane.point - ray.origin);
  if (startsOn(height, magnitude(ray.origin) + magnitude(plane.point))) return kMiss;
  const double distance = height / glm::dot(plane.normal, ray.direction);
  return distance > 0.0 ? distance : kMiss;
}

// The near intersection only: the far one is seen from inside, where a sphere is invisible.
double distanceTo(const Ball& ball, const Ray& ray) {
  const dvec3 fromCenter = ray.origin - ball.center;
  const double scale = magnitude(ray.origin) + magnitude(ball.center) + ball.radius;
  if (startsOn(glm::length(fromCenter) - ball.radius, scale)) return kMiss;
  const double along = glm::dot(fromCenter, ray.direction);
  const dvec3 offAxis = fromCenter - along * ray.direction;
  const double discriminant = ball.radius * ball.radius - glm::dot(offAxis, offAxis);
  if (discriminant < 0.0) return kMiss;
  const double distance = -along - std::sqrt(discriminant);
  return distance > 0.0 ? distance : kMiss;
}

double distanceTo(const Facet& facet, const Ray& ray) {
  const double height = glm::dot(facet.normal, facet.corners[0] - ray.origin);
  if (startsOn(height, magnitude(ray.origin) + magnitude(facet.corners[0]))) return kMiss;
  const double distance = height / glm::dot(facet.normal, ray.direction);
  if (!(distance > 0.0)) return kMiss;
  for (const EdgePass& edge : passEdges(facet, ray.origin, ray.direction)) {
    if (edge.volume < -edge.tolerance) return kMiss;
  }
  return distance;
}

Occlusion occludes(const FlatPlane& plane, const Ray& ray, const dvec3& light) {
  return crossesPlane(plane.point, plane.normal, ray.origin, light);
}

Occlusion occludes(const Facet& facet, const Ray& ray, const dvec3& light) {
  Occlusion result = crossesPlane(facet.corners[0], facet.normal, ray.origin, light);
  if (!result.blocked && result.certain) return result;
  const double atStart = std::abs(glm::dot(facet.normal, ray.origin - facet.corners[0]));
  const double atLight = std::abs(glm::dot(facet.normal, light - facet.corners[0]));
  const double error = passingError(ray.origin, light, facet.corners[0], atStart / (atStart + atLight));
  for (const EdgePass& edge : passEdges(facet, ray.origin, ray.direction)) {
    if (edge.volume < -error * edge.spread - edge.tolerance) return {};
    if (edge.volume < -edge.tolerance) result.blocked = false;
    if (edge.volume < error * edge.spread) result.certain = false;
  }
  return result;
}

Occlusion occludes(const Ball& ball, const Ray& ray, const dvec3& light) {
  const dvec3 fromCenter = ray.origin - ball.center;
  const double height = glm::length(fromCenter) - ball.radius;
  const double size = magnitude(ball.center) + ball.radius;
  if (startsOn(height, magnitude(ray.origin) + size)) return {};
  const double lightDistance = glm::distance(light, ray.origin);
  const double closest = -glm::dot(fromCenter, ray.direction);  // along the ray
  const double offAxis = glm::length(fromCenter + closest * ray.direction);
  const double error =
      passingError(ray.origin, light, ball.center, closest / lightDistance) + kFloatError * ball.radius;
  if (height < -error || closest < -error || offAxis > ball.radius + error) return {};

  Occlusion result{height > 0.0 && closest > 0.0 && offAxis <= ball.radius, true};
  result.certain = std::abs(height) > error && offAxis < ball.radius - error;
  const double lightHeight = glm::distance(light, ball.center) - ball.radius;
  const double lightScale = magnitude(light) + size;
  if (startsOn(lightHeight, lightScale)) {
    // The light is one of the two intersections. Only if it is the far one, the near one is in between.
    result.blocked = result.blocked && closest < lightDistance;
    result.certain = result.certain && std::abs(lightDistance - closest) > error;
    return result;
  }
  if (std::abs(lightHeight) <= kFloatError * lightScale) result.certain = false;
  // From a light outside the ball and before the closest approach, the ball lies further on.
  if (lightHeight > 0.0 && closest > lightDistance) return {false, lightHeight > kFloatError * lightScale};
  return result;
}

Normal shadingNormal(const FlatPlane& plane, const dvec3& direction) {
  const double facing = glm::dot(plane.normal, direction);
  return {facing > 0.0 ? -plane.normal : plane.normal, std::abs(facing) > kFloatError};
}

Normal shadingNormal(const Ball& ball, const dvec3& point) {
  return {glm::normalize(point - ball.center), true};
}

Normal shadingNormal(const Facet& facet, const dvec3& point, const dvec3& direction) {
  constexpr double kUndecided = 1e-5;
  const double facing = glm::dot(facet.normal, direction);
  const dvec3 towardsViewer = facing > 0.0 ? -facet.normal : facet.normal;
  if (!facet.smooth) return {towardsViewer, std::abs(facing) > kFloatError};
  dvec3 sum(0.0);
  double weights = 0.0;
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const dvec3& from = facet.corners[(k + 1) % 3];
    const dvec3& to = facet.corners[(k + 2) % 3];
    const double weight = glm::dot(facet.normal, glm::cross(to - from, point - from));
    sum += weight * facet.cornerNormals[k];
    weights += weight;
    longest = std::max(longest, glm::length(facet.cornerNormals[k]));
  }
  const double length = glm::length(sum) / weights;
  if (length <= kSameDistance * longest) return {towardsViewer, longest == 0.0};
  const dvec3 interpolated = glm::normalize(sum);
  // The side of the face that the interpolated normal is on is the side that `towardsViewer` is on, or the
  // normal is turned.
  const double side = glm::dot(interpolated, towardsViewer);
  const bool certain = length > kUndecided * longest && std::abs(side) > kUndecided;
  return {side < 0.0 ? -interpolated : interpolated, certain};
}

}  // namespace lavaray::oracle
