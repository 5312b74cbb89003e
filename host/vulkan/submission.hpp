#pragma once

#include <functional>

#include "vulkan/device.hpp"

namespace lavaray::vulkan {

// Work that is given to a device and waited for later. It can be submitted again once it has been waited for.
class Submission {
 public:
  explicit Submission(Device& device);
  // Waits for the work, so that what it uses can be freed afterwards.
  ~Submission();
  Submission(const Submission&) = delete;
  Submission& operator=(const Submission&) = delete;

  // Lets `record` record commands, and submits them. Work runs in the order in which it is submitted.
  void submit(const std::function<void(VkCommandBuffer)>& record);
  // Returns once the work is done.
  void wait();

 private:
  Device& device_;
  Handle<VkCommandPool, &vkDestroyCommandPool> pool_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;  // freed with the pool
  Handle<VkFence, &vkDestroyFence> fence_;
  bool isPending_ = false;  // submitted and not yet waited for
};

}  // namespace lavaray::vulkan
