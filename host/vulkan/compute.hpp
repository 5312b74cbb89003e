#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "vulkan/buffer.hpp"

namespace lavaray::vulkan {

// A compute shader with its buffers bound, ready to dispatch. Binding i of descriptor set 0 is buffers[i];
// specialization constant i is specialization[i] (0 or 1 for a bool).
class ComputeShader {
 public:
  // `buffers` must outlive the shader; their use decides the bindings' descriptor types.
  ComputeShader(Device& device, std::span<const std::uint32_t> spirv,
                std::span<const std::uint32_t> specialization, std::span<const Buffer> buffers,
                std::size_t pushConstantSize);

  // Runs `groups` work groups and returns once the host can read what they wrote.
  void dispatch(std::uint32_t groups, std::span<const std::byte> pushConstants);

 private:
  void createSet(std::span<const Buffer> buffers);

  Device* device_;
  std::shared_ptr<const Pipeline> pipeline_;
  Handle<VkDescriptorPool, &vkDestroyDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;  // freed with the pool
};

}  // namespace lavaray::vulkan
