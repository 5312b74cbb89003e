#pragma once

#include <string>
#include <vector>

#include "bvh/flatten.hpp"
#include "scene/scene.hpp"
#include "stress/shaders/stress_probes.h"
#include "support/scene_building.hpp"

namespace lavaray {

// Points of surfaces, found on the test device by the renderer's functions.
std::vector<gpu::SurfaceAnswer> findPoints(const GpuScene& scene,
                                           const std::vector<gpu::SurfaceQuery>& queries);

inline constexpr std::uint32_t kNoSurface = 0xFFFFFFFF;

// Surfaces of one kind, about one size and at about one distance from the camera, and a way to aim at them.
struct SurfaceScene {
  std::string name;
  Scene scene;
  double size;          // of the surfaces, or of the part of them that rays are aimed at
  double offset;        // of that from the camera
  bool isHuge = false;  // triangles that reach far beyond that part
};

// Sizes from 1e-4 to 1e4, offsets from 0 to 1e5, where float32 can tell the surfaces' points apart; no
// slivers, whose distance is found with fewer digits. The camera is in the origin, and vertices, centres and
// radii are floats, so that the device has the very surfaces that the test knows.
std::vector<SurfaceScene> sphereScenes();
std::vector<SurfaceScene> triangleScenes();  // without slivers
std::vector<SurfaceScene> sliverScenes();
std::vector<SurfaceScene> hugeTriangleScenes();
std::vector<SurfaceScene> planeScenes();

// A ray towards a random point of a random sphere, triangle or plane of the scene; it may graze it. It comes
// from the camera or from anywhere.
gpu::SurfaceQuery rayAtSurface(const SurfaceScene& scene, Random& random);

}  // namespace lavaray
