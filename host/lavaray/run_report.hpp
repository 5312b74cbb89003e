#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bvh/flatten.hpp"
#include "lavaray/step_times.hpp"
#include "render/render.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"
#include "vulkan/device.hpp"

namespace lavaray {

struct MeshFileReport {
  std::string file;
  std::size_t triangles;
  std::size_t vertices;
  std::size_t normals;
  std::size_t degenerateTriangles;  // dropped
};

// What is in a scene: --check.
struct SceneReport {
  std::string file;
  ImageSize image;  // the camera's
  std::size_t planes;
  std::size_t spheres;
  std::size_t triangles;
  std::size_t meshes;
  std::size_t meshTriangles;  // of all meshes
  std::size_t lights;
  std::vector<MeshFileReport> meshFiles;
};

struct HierarchyReport {
  std::size_t primitives;
  std::size_t droppedDuplicates;
  BvhQuality built;
  bool isTraversed;  // else each ray tests all primitives
  std::size_t traversedNodes;
  std::uint32_t traversedDepth;
};

// Rays a second, from when the device began to trace until it ended; 0 where it traced nothing.
struct RayRates {
  double camera;
  double mirror;
  double shadow;

  [[nodiscard]] double all() const { return camera + mirror + shadow; }
};

// All that --stats and --json say of a run.
struct RunReport {
  SceneReport scene;
  ImageSize picture;  // the whole, of which only a crop may have been rendered
  HierarchyReport hierarchy;
  RenderStatistics render;
  RayRates rayRates;
  vulkan::DeviceDescription device;
  std::size_t peakMemoryBytes;  // of the process, so far
  StepTimes times;
};

SceneReport reportScene(const Scene& scene);
RunReport reportRun(const Scene& scene, const GpuScene& gpuScene, const ImageSize& picture,
                    const vulkan::DeviceDescription& device, const RenderStatistics& render,
                    const StepTimes& times);

}  // namespace lavaray
