#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.hpp"

namespace lavaray::bench {

// A closed bumpy ball about the origin, of about so many triangles: the evenly divided faces of a cube,
// inflated, with bumps of many sizes, so that it shadows and mirrors itself however fine it is.
Mesh bumpyBall(std::size_t triangles);

// About so many spheres in a cube about the origin, one in each cell of a grid, at a random position in it.
// None overlap, so that all contestants agree on what is seen, even lavaray, which sees no sphere from
// inside.
std::vector<Sphere> sphereCloud(std::size_t count);

}  // namespace lavaray::bench
