#include "device_tracer.hpp"

#include <algorithm>

#include "cameraRays1Spirv.spv.h"
#include "cameraRays2Spirv.spv.h"
#include "cameraRays4Spirv.spv.h"
#include "render/scene_buffers.hpp"
#include "render/variant.hpp"
#include "secondaryRaysSpirv.spv.h"
#include "traceBatch1Spirv.spv.h"
#include "traceBatch2Spirv.spv.h"
#include "traceBatch4Spirv.spv.h"

namespace lavaray::bench {
namespace {

struct Modules {
  std::span<const std::uint32_t> cameraRays;
  std::span<const std::uint32_t> traceBatch;
};

Modules modulesFor(unsigned raysPerLane) {
  if (raysPerLane == 1) return {cameraRays1Spirv, traceBatch1Spirv};
  if (raysPerLane == 2) return {cameraRays2Spirv, traceBatch2Spirv};
  return {cameraRays4Spirv, traceBatch4Spirv};
}

// Enough for the picture in whole units of lanes, whose blocks of pixels are at most 8 by 4 (lane.glsl).
std::size_t rayPlaces(const ImageSize& size) {
  const auto inWholeUnits = [](int pixels, std::size_t unit) {
    return (static_cast<std::size_t>(pixels) + unit - 1) / unit * unit;
  };
  return inWholeUnits(size.width, 8) * inWholeUnits(size.height, 4);
}

}  // namespace

std::size_t rayCount(const Batch& batch) {
  return static_cast<std::size_t>(std::ranges::count_if(batch.rays, isThere));
}

DeviceTracer::DeviceTracer(vulkan::Device& device, const GpuScene& scene, unsigned raysPerLane)
    : device_(device),
      raysPerLane_(raysPerLane),
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

void DeviceTracer::dispatch(vulkan::ComputeShader& shader, unsigned raysPerInvocation) {
  const gpu::uint raysPerGroup = gpu::kWorkGroupSize * raysPerInvocation;
  shader.dispatch((constants_.rayCount + raysPerGroup - 1) / raysPerGroup,
                  std::as_bytes(std::span(&constants_, 1)));
}

Batch DeviceTracer::cameraRays(const ImagePlane& plane, const ImageSize& size) {
  Batch batch{"camera", false, true, std::vector<gpu::BatchRay>(rayPlaces(size))};
  constants_.width = static_cast<gpu::uint>(size.width);
  constants_.height = static_cast<gpu::uint>(size.height);
  constants_.focalLength = static_cast<float>(plane.distance);
  constants_.pixelSize = plane.size / glm::dvec2(size.width, size.height);
  constants_.halfImage = plane.size / 2.0;
  bindRays(batch.rays, batch.rays.size() * sizeof(gpu::BatchRay));
  vulkan::ComputeShader shader = makeShader(modulesFor(raysPerLane_).cameraRays, gpu::kBatchClosest);
  dispatch(shader, 1);
  const auto* made = reinterpret_cast<const gpu::BatchRay*>(buffers_.back().bytes());
  std::copy_n(made, batch.rays.size(), batch.rays.begin());
  return batch;
}

PictureBatches DeviceTracer::pictureRays(const ImagePlane& plane, const ImageSize& size) {
  PictureBatches batches{cameraRays(plane, size), {"shadow", true, true, {}}, {"mirror", false, false, {}}};
  const std::size_t places = batches.camera.rays.size();
  bindRays(batches.camera.rays, places * sizeof(gpu::BatchRay));
  vulkan::ComputeShader shader = makeShader(secondaryRaysSpirv, gpu::kBatchClosest);
  // All rays to one light, then all to the next, as the renderer's shader traces them.
  for (constants_.follower = 0; constants_.follower <= lights_; ++constants_.follower) {
    dispatch(shader, 1);
    const auto* made = reinterpret_cast<const gpu::BatchRay*>(buffers_.back().bytes());
    Batch& batch = constants_.follower == 0 ? batches.mirror : batches.shadow;
    batch.rays.insert(batch.rays.end(), made, made + places);
  }
  return batches;
}

void DeviceTracer::load(const Batch& batch) {
  const std::span<const std::uint32_t> module = modulesFor(raysPerLane_).traceBatch;
  bindRays(batch.rays, batch.rays.size() * sizeof(float));
  trace_.emplace(makeShader(module, batch.anyHit ? gpu::kBatchAny : gpu::kBatchClosest));
  readAndWrite_.emplace(makeShader(module, gpu::kBatchNoTrace));
}

void DeviceTracer::trace() {
  dispatch(*trace_, raysPerLane_);
}
void DeviceTracer::readAndWrite() {
  dispatch(*readAndWrite_, raysPerLane_);
}

std::span<const float> DeviceTracer::distances() const {
  return {reinterpret_cast<const float*>(buffers_.back().bytes()), constants_.rayCount};
}

}  // namespace lavaray::bench
