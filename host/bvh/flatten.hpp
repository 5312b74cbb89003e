#pragma once

#include "bvh/gpu_scene.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// Throws Error(kInput) if the scene has more than gpu::kMaxReference primitives.
GpuScene flatten(const Scene& scene, unsigned threads);

// Whether two scenes have the same hierarchy: the same spheres and triangles in the same frame.
bool sameGeometry(const Scene& a, const Scene& b);

// Turns `flat`, flattened from a scene of the same geometry, into what flatten(scene) returns: sets its
// lights, materials, planes and image plane anew.
void flattenShading(const Scene& scene, GpuScene& flat);

}  // namespace lavaray
