#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "vulkan/handle.hpp"
#include "vulkan/instance.hpp"
#include "vulkan/pipeline.hpp"

namespace lavaray::vulkan {

struct DeviceLimits {
  VkDeviceSize storageBufferRange;  // bytes
  std::uint32_t texelBufferElements;
  std::uint32_t workGroupsX;  // of one dispatch
};

// A logical device with one compute queue. One call records work, submits it and waits for it: the program
// never has two submissions in flight.
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

  [[nodiscard]] Pipelines& pipelines() { return *pipelines_; }

  // Lets `record` record commands, submits them and waits until they are done.
  void submit(const std::function<void(VkCommandBuffer)>& record);

 private:
  DeviceDescription description_;
  DeviceLimits limits_{};
  VkPhysicalDeviceMemoryProperties memory_{};
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  Handle<VkCommandPool, &vkDestroyCommandPool> pool_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;  // freed with the pool
  Handle<VkFence, &vkDestroyFence> fence_;
  std::optional<Pipelines> pipelines_;
};

}  // namespace lavaray::vulkan
