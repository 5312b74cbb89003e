#pragma once

#include <cstdint>
#include <vector>

#include "bvh/box.hpp"
#include "interface.h"
#include "scene/scene.hpp"

namespace lavaray {

// What the BVH holds: all spheres and triangles of a scene, in its Frame, in file order.
struct Primitives {
  std::vector<gpu::Primitive> shapes;
  std::vector<gpu::TrianglePlane> planes;        // one per shape if there is a triangle, else empty
  std::vector<gpu::CornerNormal> cornerNormals;  // three for each triangle that has them
};

std::size_t primitiveCount(const Scene& scene);

// Throws Error(kInput) if there are more than gpu::kMaxReference.
Primitives collectPrimitives(const Scene& scene);

// Moves the spheres before the triangles; within each kind the order stays.
void putSpheresFirst(Primitives& primitives);

// The smallest box with float32 coordinates that contains the shape.
Box boundingBox(const gpu::Primitive& shape);

// Removes shapes that coincide with an earlier one and affect no pixel: of several triangles with the same
// vertices only the first is ever seen, and none of them occludes another. Of equal spheres the first two are
// kept, because the second occludes the far side of the first. Returns the number of shapes removed.
std::size_t removeCoincident(Primitives& primitives);

}  // namespace lavaray
