#pragma once

#include <functional>
#include <optional>

#include "vulkan/activity.hpp"
#include "vulkan/buffer.hpp"

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

  // To be called before the first submit() if times() is wanted.
  void recordTimes();
  // Of the work that was waited for last.
  [[nodiscard]] const SubmissionTimes& times() const { return times_; }

 private:
  void writeTimestamps();

  Device& device_;
  Handle<VkCommandPool, &vkDestroyCommandPool> pool_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;  // freed with the pool
  Handle<VkFence, &vkDestroyFence> fence_;
  bool isPending_ = false;       // submitted and not yet waited for
  std::optional<Buffer> ticks_;  // these two: where times are recorded
  Handle<VkQueryPool, &vkDestroyQueryPool> timestamps_;
  SubmissionTimes times_;
};

}  // namespace lavaray::vulkan
