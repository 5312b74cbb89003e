#include "device/probe.hpp"

#include "device/shaders/probe.h"
#include "device/test_device.hpp"
#include "render/scene_buffers.hpp"
#include "render/variant.hpp"
#include "vulkan/compute.hpp"

namespace lavaray {

std::vector<std::byte> runProbe(std::span<const std::uint32_t> spirv, const GpuScene& scene,
                                std::span<const std::byte> queries, std::size_t queryCount,
                                std::size_t answerSize, std::span<const std::byte> constants) {
  vulkan::Device& device = testDevice();
  std::vector<vulkan::Buffer> buffers = uploadScene(device, scene);
  buffers.push_back(vulkan::Buffer::shared(device, "queries", queries.size()));
  buffers.push_back(vulkan::Buffer::shared(device, "answers", queryCount * answerSize));
  std::memcpy(buffers[gpu::kBindingProbeIn].bytes(), queries.data(), queries.size());
  vulkan::ComputeShader shader(device, spirv, specializationFor(scene), buffers, constants.size());
  const std::size_t groups = (queryCount + gpu::kWorkGroupSize - 1) / gpu::kWorkGroupSize;
  shader.dispatch(static_cast<std::uint32_t>(groups), constants);
  const std::byte* answers = buffers[gpu::kBindingProbeOut].bytes();
  return {answers, answers + queryCount * answerSize};
}

}  // namespace lavaray
