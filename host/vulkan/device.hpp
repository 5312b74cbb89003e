#pragma once

#include <cstdint>
#include <mutex>
#include <optional>

#include "vulkan/handle.hpp"
#include "vulkan/instance.hpp"
#include "vulkan/pipeline.hpp"

namespace lavaray::vulkan {

struct DeviceLimits {
  VkDeviceSize storageBufferRange;  // bytes
  std::uint32_t texelBufferElements;
  std::uint32_t workGroupsX;  // of one dispatch
  double timestampSeconds;    // of a tick; 0 where the queue has none, or such as soon wrap around
};

// A logical device with one compute queue, to which Submissions give work.
class Device {
 public:
  explicit Device(const DeviceDescription& description);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  [[nodiscard]] VkDevice get() const { return device_; }
  [[nodiscard]] const DeviceDescription& description() const { return description_; }
  [[nodiscard]] const DeviceLimits& limits() const { return limits_; }
  [[nodiscard]] const VkPhysicalDeviceMemoryProperties& memory() const { return memory_; }

  [[nodiscard]] std::uint32_t queueFamily() const { return queueFamily_; }
  // Threads may share the device, but the queue is for one at a time.
  [[nodiscard]] VkResult submit(const VkSubmitInfo& info, VkFence fence);
  [[nodiscard]] VkResult waitUntilIdle();

  [[nodiscard]] Pipelines& pipelines() { return *pipelines_; }

 private:
  DeviceDescription description_;
  DeviceLimits limits_{};
  VkPhysicalDeviceMemoryProperties memory_{};
  VkDevice device_ = VK_NULL_HANDLE;
  std::uint32_t queueFamily_ = 0;
  std::mutex queueMutex_;
  VkQueue queue_ = VK_NULL_HANDLE;
  std::optional<Pipelines> pipelines_;
};

}  // namespace lavaray::vulkan
