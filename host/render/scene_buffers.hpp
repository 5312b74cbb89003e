#pragma once

#include <vector>

#include "bvh/gpu_scene.hpp"
#include "vulkan/buffer.hpp"

namespace lavaray {

// How shaders read the scene's arrays: as texels, which is faster on lavapipe, or as storage buffers if an
// array has more texels than the device allows.
vulkan::BufferUse sceneUse(const vulkan::Device& device, const GpuScene& scene);

// The scene's arrays on the device, in the order of their bindings, from gpu::kBindingNodes on; a shader's
// own buffers follow. Throws Error(kDevice) if an array is larger than what a shader can reach.
std::vector<vulkan::Buffer> uploadScene(vulkan::Device& device, const GpuScene& scene,
                                        vulkan::BufferUse use = vulkan::BufferUse::kTexels);

}  // namespace lavaray
