#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "batch.h"
#include "bvh/flatten.hpp"
#include "vulkan/compute.hpp"

namespace lavaray::bench {

// Rays of one kind, that are traced together.
struct Batch {
  std::string name;
  bool anyHit = false;      // any hit will do, as for a shadow ray; else the first is sought
  bool isCoherent = false;  // neighbours go about the same way
  std::vector<gpu::BatchRay> rays;
};

// The batches of a picture: its camera rays and, from the points they hit, the mirrored rays and the shadow
// rays.
struct PictureBatches {
  Batch camera;
  Batch shadow;
  Batch mirror;
};

// A scene on a Vulkan device, whose rays are traced by the renderer's own shader code.
class DeviceTracer {
 public:
  DeviceTracer(vulkan::Device& device, const GpuScene& scene);

  // The rays that the renderer would trace from the points that the camera rays hit.
  PictureBatches follow(Batch camera);

  // What trace() traces from now on.
  void load(const Batch& batch);
  void trace();
  // Reads the rays and writes as many results as trace(), without tracing.
  void readAndWrite();
  // A distance for each ray: infinity for a miss, NaN where the device could not finish the search.
  [[nodiscard]] std::span<const float> distances() const;

  [[nodiscard]] std::size_t sceneBytes() const { return sceneBytes_; }

 private:
  void bindRays(std::span<const gpu::BatchRay> rays, std::size_t resultBytes);
  vulkan::ComputeShader makeShader(std::span<const std::uint32_t> spirv, gpu::uint mode);
  void dispatch(vulkan::ComputeShader& shader);

  vulkan::Device& device_;
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
