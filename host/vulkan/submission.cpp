#include "vulkan/submission.hpp"

#include <cassert>
#include <chrono>
#include <cstdint>

#include "vulkan/result.hpp"

namespace lavaray::vulkan {
namespace {

using Tick = std::uint64_t;
constexpr std::uint32_t kTimestamps = 2;  // when the work begins and when it ends

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

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
    (void)device_.waitUntilIdle();
}

void Submission::recordTimes() {
  if (device_.limits().timestampSeconds == 0.0) return;
  VkQueryPoolCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = kTimestamps;
  VkQueryPool pool = VK_NULL_HANDLE;
  check(vkCreateQueryPool(device_.get(), &info, nullptr, &pool),
        "make a query pool for " + device_.description().name);
  timestamps_ = {device_.get(), pool};
  ticks_.emplace(Buffer::shared(device_, "times", kTimestamps * sizeof(Tick)));
}

void Submission::submit(const std::function<void(VkCommandBuffer)>& record) {
  assert(!isPending_);
  const std::string& name = device_.description().name;
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands_, &begin), "begin the command buffer of " + name);
  const VkQueryPool timestamps = timestamps_.get();
  if (timestamps != VK_NULL_HANDLE) {
    vkCmdResetQueryPool(commands_, timestamps, 0, kTimestamps);
    vkCmdWriteTimestamp(commands_, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, timestamps, 0);
  }
  record(commands_);
  if (timestamps != VK_NULL_HANDLE) writeTimestamps();
  check(vkEndCommandBuffer(commands_), "end the command buffer of " + name);

  VkSubmitInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  info.commandBufferCount = 1;
  info.pCommandBuffers = &commands_;
  times_.submitted = now();
  check(device_.submit(info, fence_.get()), "submit work to " + name);
  isPending_ = true;
}

void Submission::wait() {
  assert(isPending_);
  const std::string& name = device_.description().name;
  const VkFence fence = fence_.get();
  times_.waitBegin = now();
  // Until it succeeds the work counts as pending: it may still be running, and the exception leads to the
  // destructor.
  check(vkWaitForFences(device_.get(), 1, &fence, VK_TRUE, UINT64_MAX), "wait for " + name);
  isPending_ = false;
  times_.waitEnd = now();
  check(vkResetFences(device_.get(), 1, &fence), "reset the fence of " + name);
  if (!ticks_) return;
  const auto* ticks = reinterpret_cast<const Tick*>(ticks_->bytes());
  const double tick = device_.limits().timestampSeconds;
  times_.onDevice = {static_cast<double>(ticks[0]) * tick, static_cast<double>(ticks[1]) * tick};
}

// By the device, since vkGetQueryPoolResults of Mesa's software driver waits for all work that was submitted.
void Submission::writeTimestamps() {
  vkCmdWriteTimestamp(commands_, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, timestamps_.get(), 1);
  vkCmdCopyQueryPoolResults(commands_, timestamps_.get(), 0, kTimestamps, ticks_->get(), 0, sizeof(Tick),
                            VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
  VkMemoryBarrier barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vkCmdPipelineBarrier(commands_, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier,
                       0, nullptr, 0, nullptr);
}

}  // namespace lavaray::vulkan
