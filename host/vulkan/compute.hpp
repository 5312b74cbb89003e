#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "vulkan/buffer.hpp"

namespace lavaray::vulkan {

// A compute shader with its buffers bound, ready to be dispatched. Binding i of descriptor set 0 is
// buffers[i], and specialization constant i has the value specialization[i] (a bool is 0 or 1).
class ComputeShader {
 public:
  // `buffers` must outlive the shader; a binding's kind is its buffer's use.
  ComputeShader(Device& device, std::span<const std::uint32_t> spirv,
                std::span<const std::uint32_t> specialization, std::span<const Buffer> buffers,
                std::size_t pushConstantSize);

  // Runs `groups` work groups and waits until the host can read what they wrote.
  void dispatch(std::uint32_t groups, std::span<const std::byte> pushConstants);

 private:
  void createSet(std::span<const Buffer> buffers);

  Device* device_;
  std::shared_ptr<const Pipeline> pipeline_;
  Handle<VkDescriptorPool, &vkDestroyDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;  // freed with the pool
};

}  // namespace lavaray::vulkan
