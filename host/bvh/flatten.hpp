#pragma once

#include <cstdint>
#include <vector>

#include "bvh/bvh.hpp"
#include "interface.h"
#include "scene/scene.hpp"

namespace lavaray {

// The scene as the shaders read it: float32, in the coordinates of its Frame. Going there in double precision
// first gives the coordinates near the camera their full precision wherever the scene lies.
struct GpuScene {
  std::vector<gpu::BvhNode> nodes;                 // see WideBvh; empty where there are no primitives
  std::uint32_t bvhDepth = 0;                      // of them: inner nodes on the longest path
  std::vector<gpu::Primitive> primitives;          // in the order of the BVH's leaves
  std::vector<gpu::TrianglePlane> trianglePlanes;  // one a primitive where there is a triangle, else empty
  std::vector<gpu::CornerNormal> cornerNormals;    // three for each triangle that has them
  std::vector<gpu::Plane> planes;
  std::vector<gpu::Light> lights;
  std::vector<gpu::Material> materials;  // indexed by object
  bool hasFewPrimitives = false;         // see there; then the spheres are the first ones
  bool hasSpheres = false;
  bool hasTriangles = false;
  bool hasCornerNormals = false;
  bool hasMirrors = false;
  bool hasSphericalLights = false;
  BvhQuality bvhQuality;
  std::size_t droppedDuplicates = 0;  // primitives that coincide with another and can never be seen
};

// Whether the scene has no more than gpu::kMaxFewPrimitives, so that its rays test each of them.
bool hasFewPrimitives(const Scene& scene);

// Throws Error(kInput) where the scene has more than gpu::kMaxReference primitives.
GpuScene flatten(const Scene& scene, unsigned threads);

// Whether two scenes have the same hierarchy: the same spheres and triangles, in the same frame.
bool sameGeometry(const Scene& a, const Scene& b);

// Makes `flat`, flattened from a scene of the same geometry, what flatten(scene) returns.
void flattenShading(const Scene& scene, GpuScene& flat);

}  // namespace lavaray
