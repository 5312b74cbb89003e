#include "vulkan/device.hpp"

#include <vector>

#include "vulkan/result.hpp"

namespace lavaray::vulkan {
namespace {

// Prefers a family without graphics, whose work does not queue behind a desktop's drawing.
std::uint32_t computeFamily(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
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
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(description.handle, &properties);
  limits_ = {properties.limits.maxStorageBufferRange, properties.limits.maxTexelBufferElements,
             properties.limits.maxComputeWorkGroupCount[0]};
  vkGetPhysicalDeviceMemoryProperties(description.handle, &memory_);

  const std::uint32_t family = computeFamily(description.handle);
  device_ = createDevice(description, family);
  vkGetDeviceQueue(device_, family, 0, &queue_);

  VkCommandPoolCreateInfo poolInfo{};
  poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  poolInfo.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  poolInfo.queueFamilyIndex = family;
  VkCommandPool pool = VK_NULL_HANDLE;
  check(vkCreateCommandPool(device_, &poolInfo, nullptr, &pool),
        "make a command pool for " + description.name);
  pool_ = {device_, pool};

  VkCommandBufferAllocateInfo bufferInfo{};
  bufferInfo.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  bufferInfo.commandPool = pool;
  bufferInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  bufferInfo.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(device_, &bufferInfo, &commands_),
        "make a command buffer for " + description.name);

  VkFenceCreateInfo fenceInfo{};
  fenceInfo.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  VkFence fence = VK_NULL_HANDLE;
  check(vkCreateFence(device_, &fenceInfo, nullptr, &fence), "make a fence for " + description.name);
  fence_ = {device_, fence};
  pipelines_.emplace(device_);
}

Device::~Device() {
  // They belong to the device and must go before it.
  pipelines_.reset();
  fence_ = {};
  pool_ = {};
  vkDestroyDevice(device_, nullptr);
}

void Device::submit(const std::function<void(VkCommandBuffer)>& record) {
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands_, &begin), "begin the command buffer of " + description_.name);
  record(commands_);
  check(vkEndCommandBuffer(commands_), "end the command buffer of " + description_.name);

  VkSubmitInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  info.commandBufferCount = 1;
  info.pCommandBuffers = &commands_;
  const VkFence fence = fence_.get();
  check(vkQueueSubmit(queue_, 1, &info, fence), "submit work to " + description_.name);
  const VkResult waited = vkWaitForFences(device_, 1, &fence, VK_TRUE, UINT64_MAX);
  // The work may still be running, and the exception destroys the buffers that it uses.
  if (waited != VK_SUCCESS) (void)vkDeviceWaitIdle(device_);
  check(waited, "wait for " + description_.name);
  check(vkResetFences(device_, 1, &fence), "reset the fence of " + description_.name);
}

}  // namespace lavaray::vulkan
