#pragma once

#include <cstddef>
#include <vector>

#include "core/scene.hpp"

namespace lavaray::bench {

// A closed bumpy ball about the origin of about so many triangles: a cube's faces divided evenly and blown
// up, with bumps of many sizes, so that it shadows and mirrors itself however fine it is.
Mesh bumpyBall(std::size_t triangles);

// Spheres at random places in a cube about the origin, that cover about the same part of the view whatever
// their number.
std::vector<Sphere> sphereCloud(std::size_t count);

}  // namespace lavaray::bench
