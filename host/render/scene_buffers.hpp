#pragma once

#include <cstdint>
#include <vector>

#include "bvh/flatten.hpp"
#include "vulkan/buffer.hpp"

namespace lavaray {

// How shaders read the scene's arrays on the device: as texels, which is the faster way on lavapipe, or,
// where one has more of them than the device allows, as storage buffers.
vulkan::BufferUse sceneUse(const vulkan::Device& device, const GpuScene& scene);

// The scene's arrays on the device, in the order of their bindings (gpu::kBindingNodes and on); a shader's
// own buffers follow. Throws Error(kDevice) where an array is larger than the device lets a shader reach.
std::vector<vulkan::Buffer> uploadScene(vulkan::Device& device, const GpuScene& scene,
                                        vulkan::BufferUse use = vulkan::BufferUse::kTexels);

// The specialization constants, by gpu::kSpec..., with those set that say what the scene has.
std::vector<std::uint32_t> specializationFor(const GpuScene& scene);

}  // namespace lavaray
