#pragma once

#include <cstdint>
#include <vector>

#include "oracle/shapes.hpp"
#include "scene/scene.hpp"

namespace lavaray::oracle {

// All surfaces of a scene, and the questions that a ray tracer asks of them. No tree: a ray goes through the
// whole list.

// Surfaces are numbered planes first, then balls, then facets.
struct Geometry {
  std::vector<FlatPlane> planes;
  std::vector<Ball> balls;
  std::vector<Facet> facets;
  // Bounding spheres of the facets, one array for each coordinate, and of each 64 facets in the order of the
  // file. They spare the exact test where a ray is clear of a facet, and that is all they do.
  std::vector<double> boundX, boundY, boundZ, boundRadius;
  std::vector<Ball> blocks;
};

Geometry flatten(const Scene& scene);

struct Hit {
  double distance = 0.0;
  std::uint32_t surface = kNoSurface;
};

// What the ray meets: first the surface that is seen, then those that a float32 renderer could take for it.
// Empty where it meets nothing.
std::vector<Hit> nearestHits(const Geometry& geometry, const Ray& ray);

// Does a surface other than `surface` lie between the point on it and the light?
Occlusion occlusion(const Geometry& geometry, const glm::dvec3& point, std::uint32_t surface,
                    const glm::dvec3& light);

const Identity& identity(const Geometry& geometry, std::uint32_t surface);

Normal shadingNormal(const Geometry& geometry, std::uint32_t surface, const glm::dvec3& point,
                     const glm::dvec3& direction);

}  // namespace lavaray::oracle
