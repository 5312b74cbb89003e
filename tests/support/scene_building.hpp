#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.hpp"
#include "support/random_numbers.hpp"

namespace lavaray {

// Scenes made by tests: shapes with an object of their own each, and a ray from place to place.

void addTriangle(Scene& scene, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);
void addSphere(Scene& scene, const glm::dvec3& center, double radius);
void addPlane(Scene& scene, const glm::dvec3& normal, const glm::dvec3& point);

// Triangles of up to 2 in size, the first corner within 10 of the place on each axis.
void addRandomTriangles(Scene& scene, int count, const glm::dvec3& place, Random& random);

// A grid of (rings + 1) x rings points on a sphere about the origin, its radius 1 and `bump` more or less.
// The first and the last row are the poles, on the y axis; the columns run around it.
using Grid = std::vector<std::vector<glm::dvec3>>;
Grid sphereGrid(int rings, double bump, Random& random);

// The closed mesh of 2 rings (rings - 1) triangles through the grid's points. Vertices of one point are equal
// to the bit; each triangle begins with a random one of its corners.
void addGrid(Scene& scene, const Grid& grid, Random& random);

}  // namespace lavaray
