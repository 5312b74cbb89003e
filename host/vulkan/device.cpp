#include "vulkan/device.hpp"

#include <vector>

#include "vulkan/result.hpp"

namespace lavaray::vulkan {
namespace {

std::vector<VkQueueFamilyProperties> queueFamilies(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  return families;
}

// Prefers a family without graphics, whose work does not queue behind a desktop's drawing.
std::uint32_t computeFamily(const std::vector<VkQueueFamilyProperties>& families) {
  const auto count = static_cast<std::uint32_t>(families.size());
  std::uint32_t chosen = count;
  for (std::uint32_t i = 0; i < count; ++i) {
    const VkQueueFlags flags = families[i].queueFlags;
    if ((flags & VK_QUEUE_COMPUTE_BIT) == 0) continue;
    if (chosen == count || (flags & VK_QUEUE_GRAPHICS_BIT) == 0) chosen = i;
  }
  return chosen;
}

VkDevice createDevice(const DeviceDescription& description, std::uint32_t family) {
  const float priority = 1.0F;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  VkDevice device = VK_NULL_HANDLE;
  check(vkCreateDevice(description.handle, &info, nullptr, &device), "open the device " + description.name);
  return device;
}

}  // namespace

Device::Device(const DeviceDescription& description) : description_(description) {
  const std::vector<VkQueueFamilyProperties> families = queueFamilies(description.handle);
  queueFamily_ = computeFamily(families);
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(description.handle, &properties);
  const bool hasLongTimestamps = families[queueFamily_].timestampValidBits == 64;
  limits_ = {.storageBufferRange = properties.limits.maxStorageBufferRange,
             .texelBufferElements = properties.limits.maxTexelBufferElements,
             .workGroupsX = properties.limits.maxComputeWorkGroupCount[0],
             .timestampSeconds = hasLongTimestamps ? 1e-9 * double{properties.limits.timestampPeriod} : 0.0};
  vkGetPhysicalDeviceMemoryProperties(description.handle, &memory_);

  device_ = createDevice(description, queueFamily_);
  vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);
  pipelines_.emplace(device_);
}

Device::~Device() {
  // They belong to the device and must go before it.
  pipelines_.reset();
  vkDestroyDevice(device_, nullptr);
}

VkResult Device::submit(const VkSubmitInfo& info, VkFence fence) {
  const std::lock_guard lock(queueMutex_);
  return vkQueueSubmit(queue_, 1, &info, fence);
}

VkResult Device::waitUntilIdle() {
  const std::lock_guard lock(queueMutex_);
  return vkDeviceWaitIdle(device_);
}

}  // namespace lavaray::vulkan
