#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "vulkan/buffer.hpp"
#include "vulkan/submission.hpp"

namespace lavaray::vulkan {

// A compute shader with its buffers bound, ready to dispatch. Binding i of descriptor set 0 is buffers[i],
// and ownBuffers follow; specialization constant i is specialization[i] (0 or 1 for a bool).
class ComputeShader {
 public:
  // The buffers must outlive the shader, and so its work; their use decides the bindings' descriptor types.
  // Several shaders may share the first ones.
  ComputeShader(Device& device, std::span<const std::uint32_t> spirv,
                std::span<const std::uint32_t> specialization, std::span<const Buffer> buffers,
                std::size_t pushConstantSize, std::span<const Buffer> ownBuffers = {});

  // Has the device run `groups` work groups, after all that it was given before.
  void start(std::uint32_t groups, std::span<const std::byte> pushConstants);
  // Returns once they have run and the host can read what they wrote. Then the shader can be started again.
  void wait();
  // See Submission.
  void recordTimes() { work_->recordTimes(); }
  [[nodiscard]] const SubmissionTimes& times() const { return work_->times(); }
  // Starts and waits.
  void dispatch(std::uint32_t groups, std::span<const std::byte> pushConstants);

 private:
  void createSet(std::span<const Buffer* const> buffers);

  Device* device_;
  std::shared_ptr<const Pipeline> pipeline_;
  Handle<VkDescriptorPool, &vkDestroyDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;  // freed with the pool
  std::unique_ptr<Submission> work_;      // goes first, since it waits for what uses the others
};

}  // namespace lavaray::vulkan
