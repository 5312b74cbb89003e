#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "bvh/flatten.hpp"

namespace lavaray {

// A search for the first of the scene's spheres that a ray hits, or for any of them, in double precision and
// by recursion, with the tree and the order of the shader's: so it tests the same nodes and primitives,
// unless rounding may decide.
struct CountedSearch {
  glm::dvec3 origin;
  glm::dvec3 direction;
  double end;             // how far to search, in lengths of the direction; becomes that of the first hit
  std::uint32_t skipped;  // sphere, or one that is not there
  bool isAny = false;

  std::uint32_t hit = 0xFFFFFFFF;
  std::uint32_t tests = 0;
  bool isClear = true;  // rounding decided nothing
};

// `start` is a packed group of one child at most, see interface.h.
void run(const GpuScene& scene, gpu::uint start, CountedSearch& search);

}  // namespace lavaray
