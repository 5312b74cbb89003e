#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "batch.h"
#include "bvh/flatten.hpp"
#include "scene/camera.hpp"
#include "vulkan/compute.hpp"

namespace lavaray::bench {

// Rays of one kind that are traced together. They are in the order in which the renderer's lanes take them,
// and where a lane has no ray, one is in its place that is not there.
struct Batch {
  std::string name;
  bool anyHit = false;      // any hit will do, as for a shadow ray; else the first is wanted
  bool isCoherent = false;  // neighbours have similar paths
  std::vector<gpu::BatchRay> rays;
};

inline bool isThere(const gpu::BatchRay& ray) {
  return ray.tMax > 0.0F;
}

// Of the rays that are there.
std::size_t rayCount(const Batch& batch);

// The batches of a picture: its camera rays and, from the points that they hit, mirror rays and shadow rays.
struct PictureBatches {
  Batch camera;
  Batch shadow;
  Batch mirror;
};

// A scene on a Vulkan device. The renderer's own shader code traces its rays, `raysPerLane` of them together.
class DeviceTracer {
 public:
  DeviceTracer(vulkan::Device& device, const GpuScene& scene, unsigned raysPerLane);

  // The rays of a picture with one sample at each pixel's centre. All surfaces reflect.
  PictureBatches pictureRays(const ImagePlane& plane, const ImageSize& size);

  // The rays that trace() traces from now on.
  void load(const Batch& batch);
  void trace();
  // Reads and writes as much as trace(), without tracing.
  void readAndWrite();
  // A distance per ray: infinity for a miss or no ray, NaN if the device could not finish the search, any
  // number for an any-hit.
  [[nodiscard]] std::span<const float> distances() const;

  [[nodiscard]] unsigned raysPerLane() const { return raysPerLane_; }
  [[nodiscard]] std::size_t sceneBytes() const { return sceneBytes_; }

 private:
  Batch cameraRays(const ImagePlane& plane, const ImageSize& size);
  void bindRays(std::span<const gpu::BatchRay> rays, std::size_t resultBytes);
  vulkan::ComputeShader makeShader(std::span<const std::uint32_t> spirv, gpu::uint mode);
  void dispatch(vulkan::ComputeShader& shader, unsigned raysPerInvocation);

  vulkan::Device& device_;
  unsigned raysPerLane_;
  std::vector<std::uint32_t> specialization_;
  std::vector<vulkan::Buffer> buffers_;  // the scene's, then rays and results
  std::size_t sceneBuffers_;
  std::size_t sceneBytes_ = 0;
  std::size_t lights_;
  gpu::BatchConstants constants_{};
  std::optional<vulkan::ComputeShader> trace_;
  std::optional<vulkan::ComputeShader> readAndWrite_;
};

}  // namespace lavaray::bench
