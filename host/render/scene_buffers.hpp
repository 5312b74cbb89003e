#pragma once

#include <vector>

#include "bvh/gpu_scene.hpp"
#include "vulkan/buffer.hpp"

namespace lavaray {

// How shaders read the scene's arrays on the device: as texels, which is the faster way on lavapipe, or,
// where one has more of them than the device allows, as storage buffers.
vulkan::BufferUse sceneUse(const vulkan::Device& device, const GpuScene& scene);

// The scene's arrays on the device, in the order of their bindings (gpu::kBindingNodes and on); a shader's
// own buffers follow. Throws Error(kDevice) where an array is larger than the device lets a shader reach.
std::vector<vulkan::Buffer> uploadScene(vulkan::Device& device, const GpuScene& scene,
                                        vulkan::BufferUse use = vulkan::BufferUse::kTexels);

}  // namespace lavaray
