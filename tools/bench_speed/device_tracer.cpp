#include "device_tracer.hpp"

#include "render/scene_buffers.hpp"
#include "render/variant.hpp"
#include "secondaryRaysSpirv.spv.h"
#include "traceBatchSpirv.spv.h"

namespace lavaray::bench {

DeviceTracer::DeviceTracer(vulkan::Device& device, const GpuScene& scene)
    : device_(device),
      specialization_(specializationFor(scene)),
      buffers_(uploadScene(device, scene)),
      sceneBuffers_(buffers_.size()),
      lights_(scene.lights.size()) {
  for (const vulkan::Buffer& buffer : buffers_) sceneBytes_ += buffer.size();
  specialization_.resize(gpu::kSpecBatchCount);
}

void DeviceTracer::bindRays(std::span<const gpu::BatchRay> rays, std::size_t resultBytes) {
  trace_.reset();
  readAndWrite_.reset();
  buffers_.erase(buffers_.begin() + static_cast<std::ptrdiff_t>(sceneBuffers_), buffers_.end());
  buffers_.push_back(
      vulkan::Buffer::uploaded(device_, "rays", vulkan::BufferUse::kTexels, std::as_bytes(rays)));
  buffers_.push_back(vulkan::Buffer::shared(device_, "results", resultBytes));
  constants_.rayCount = static_cast<gpu::uint>(rays.size());
}

vulkan::ComputeShader DeviceTracer::makeShader(std::span<const std::uint32_t> spirv, gpu::uint mode) {
  specialization_[gpu::kSpecBatchMode] = mode;
  return {device_, spirv, specialization_, buffers_, sizeof constants_};
}

void DeviceTracer::dispatch(vulkan::ComputeShader& shader) {
  shader.dispatch((constants_.rayCount + gpu::kWorkGroupSize - 1) / gpu::kWorkGroupSize,
                  std::as_bytes(std::span(&constants_, 1)));
}

PictureBatches DeviceTracer::follow(Batch camera) {
  const std::size_t followers = 1 + lights_;
  const std::size_t count = camera.rays.size() * followers;
  bindRays(camera.rays, count * sizeof(gpu::BatchRay));
  vulkan::ComputeShader shader = makeShader(secondaryRaysSpirv, gpu::kBatchClosest);
  dispatch(shader);
  const auto* made = reinterpret_cast<const gpu::BatchRay*>(buffers_.back().bytes());
  PictureBatches batches{std::move(camera), {"shadow", true, true, {}}, {"mirror", false, false, {}}};
  // All rays to one light, then all to the next, as the renderer's shader traces them.
  for (std::size_t follower = 0; follower < followers; ++follower) {
    Batch& batch = follower == 0 ? batches.mirror : batches.shadow;
    for (std::size_t i = follower; i < count; i += followers) {
      if (made[i].tMax > 0.0F) batch.rays.push_back(made[i]);
    }
  }
  return batches;
}

void DeviceTracer::load(const Batch& batch) {
  bindRays(batch.rays, batch.rays.size() * sizeof(float));
  trace_.emplace(makeShader(traceBatchSpirv, batch.anyHit ? gpu::kBatchAny : gpu::kBatchClosest));
  readAndWrite_.emplace(makeShader(traceBatchSpirv, gpu::kBatchNoTrace));
}

void DeviceTracer::trace() {
  dispatch(*trace_);
}
void DeviceTracer::readAndWrite() {
  dispatch(*readAndWrite_);
}

std::span<const float> DeviceTracer::distances() const {
  return {reinterpret_cast<const float*>(buffers_.back().bytes()), constants_.rayCount};
}

}  // namespace lavaray::bench
