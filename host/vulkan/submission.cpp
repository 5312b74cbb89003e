#include "vulkan/submission.hpp"

#include <cassert>

#include "vulkan/result.hpp"

namespace lavaray::vulkan {

Submission::Submission(Device& device) : device_(device) {
  const std::string& name = device.description().name;
  VkCommandPoolCreateInfo poolInfo{};
  poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  poolInfo.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  poolInfo.queueFamilyIndex = device.queueFamily();
  VkCommandPool pool = VK_NULL_HANDLE;
  check(vkCreateCommandPool(device.get(), &poolInfo, nullptr, &pool), "make a command pool for " + name);
  pool_ = {device.get(), pool};

  VkCommandBufferAllocateInfo bufferInfo{};
  bufferInfo.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  bufferInfo.commandPool = pool;
  bufferInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  bufferInfo.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(device.get(), &bufferInfo, &commands_), "make a command buffer for " + name);

  VkFenceCreateInfo fenceInfo{};
  fenceInfo.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  VkFence fence = VK_NULL_HANDLE;
  check(vkCreateFence(device.get(), &fenceInfo, nullptr, &fence), "make a fence for " + name);
  fence_ = {device.get(), fence};
}

Submission::~Submission() {
  if (!isPending_) return;
  const VkFence fence = fence_.get();
  if (vkWaitForFences(device_.get(), 1, &fence, VK_TRUE, UINT64_MAX) != VK_SUCCESS)
    (void)vkDeviceWaitIdle(device_.get());
}

void Submission::submit(const std::function<void(VkCommandBuffer)>& record) {
  assert(!isPending_);
  const std::string& name = device_.description().name;
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands_, &begin), "begin the command buffer of " + name);
  record(commands_);
  check(vkEndCommandBuffer(commands_), "end the command buffer of " + name);

  VkSubmitInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  info.commandBufferCount = 1;
  info.pCommandBuffers = &commands_;
  check(vkQueueSubmit(device_.queue(), 1, &info, fence_.get()), "submit work to " + name);
  isPending_ = true;
}

void Submission::wait() {
  assert(isPending_);
  const std::string& name = device_.description().name;
  const VkFence fence = fence_.get();
  // Until it succeeds the work counts as pending: it may still be running, and the exception leads to the
  // destructor.
  check(vkWaitForFences(device_.get(), 1, &fence, VK_TRUE, UINT64_MAX), "wait for " + name);
  isPending_ = false;
  check(vkResetFences(device_.get(), 1, &fence), "reset the fence of " + name);
}

}  // namespace lavaray::vulkan
