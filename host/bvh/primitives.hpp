#pragma once

#include <cstdint>
#include <vector>

#include "bvh/box.hpp"
#include "interface.h"
#include "scene/scene.hpp"

namespace lavaray {

// What the BVH holds: all spheres and triangles of a scene, relative to the camera, in the order of the file.
struct Primitives {
  std::vector<gpu::Primitive> shapes;
  std::vector<gpu::TrianglePlane> planes;        // one a shape where there is a triangle, else empty
  std::vector<gpu::CornerNormal> cornerNormals;  // three for each triangle that has them
};

// How many that are.
std::size_t primitiveCount(const Scene& scene);

// Throws Error(kInput) where there are more than gpu::kMaxReference.
Primitives collectPrimitives(const Scene& scene);

// Brings the spheres before the triangles and leaves the order of each.
void putSpheresFirst(Primitives& primitives);

// The smallest box of float32 coordinates that holds the shape.
Box boundingBox(const gpu::Primitive& shape);

// Removes shapes that coincide with an earlier one and change no pixel: of several triangles with the same
// vertices only the first is ever seen, and none of them blocks another. Of equal spheres the first two are
// kept, since the second one blocks the far side of the first. Returns how many it removed.
std::size_t removeCoincident(Primitives& primitives);

}  // namespace lavaray
