#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/uninitialized_vector.hpp"
#include "bvh/bvh.hpp"
#include "bvh/scene_features.hpp"
#include "interface.h"
#include "scene/camera.hpp"

namespace lavaray {

// The scene as the shaders read it: float32, in the coordinates of its Frame (frame.hpp). Getting there in
// double precision keeps the full precision of coordinates near the camera, wherever the scene lies.
struct GpuScene : SceneFeatures {
  UninitializedVector<gpu::BvhNode> nodes;  // see WideBvh; empty if there are no primitives
  std::uint32_t bvhDepth = 0;               // inner nodes on the longest path
  UninitializedVector<gpu::Primitive>
      primitives;  // in the order of the BVH's leaves; few of them: spheres first
  UninitializedVector<gpu::TrianglePlane>
      trianglePlanes;  // one per primitive if there is a triangle, else empty
  UninitializedVector<gpu::CornerNormal> cornerNormals;  // three for each triangle that has them
  std::vector<gpu::Plane> planes;
  std::vector<gpu::Light> lights;
  std::vector<gpu::Material> materials;  // indexed by object
  ImagePlane imagePlane{};               // in pixels of the camera, not in units of the Frame
  double scale = 1.0;                    // of the Frame: its lengths over those of the scene
  BvhQuality bvhQuality;
  std::size_t droppedDuplicates = 0;  // primitives that coincide with another and can never be seen
};

}  // namespace lavaray
