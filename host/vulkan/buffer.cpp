#include "vulkan/buffer.hpp"

#include <array>
#include <cstring>
#include <optional>

#include "base/errors.hpp"
#include "base/huge_pages.hpp"
#include "vulkan/result.hpp"
#include "vulkan/submission.hpp"

namespace lavaray::vulkan {
namespace {

constexpr VkFormat kTexelFormat = VK_FORMAT_R32G32B32A32_UINT;

constexpr VkMemoryPropertyFlags kOnDevice = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
constexpr VkMemoryPropertyFlags kOnHost =
    VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
constexpr VkMemoryPropertyFlags kHostCached = kOnHost | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;

// The first memory type that is allowed and has all of the properties.
std::optional<std::uint32_t> findMemoryType(const Device& device, std::uint32_t allowedTypes,
                                            VkMemoryPropertyFlags properties) {
  for (std::uint32_t type = 0; type < device.memory().memoryTypeCount; ++type) {
    const bool allowed = (allowedTypes & (1U << type)) != 0;
    if (allowed && (device.memory().memoryTypes[type].propertyFlags & properties) == properties) return type;
  }
  return std::nullopt;
}

std::string inMegabytes(std::uint64_t bytes) {
  return std::to_string((bytes + (1U << 20U) - 1) >> 20U) + " MiB";
}

// A larger buffer can be made, but a shader could not reach its end.
void checkReach(const Device& device, const std::string& name, BufferUse use, std::size_t size) {
  const std::uint64_t reach = use == BufferUse::kTexels
                                  ? std::uint64_t{device.limits().texelBufferElements} * kTexelBytes
                                  : device.limits().storageBufferRange;
  if (size <= reach) return;
  throw Error(ExitCode::kDevice, "the " + name + " take " + std::to_string(size) + " bytes (" +
                                     inMegabytes(size) + "); " + device.description().name + " allows " +
                                     std::to_string(reach) + " (" + inMegabytes(reach) +
                                     ") in one buffer; a smaller scene may fit");
}

}  // namespace

VkDescriptorType descriptorType(BufferUse use) {
  return use == BufferUse::kTexels ? VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER
                                   : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

Buffer::Buffer(Device& device, const std::string& name, std::size_t size, BufferUse use,
               VkBufferUsageFlags usage, std::span<const VkMemoryPropertyFlags> memoryWishes)
    : device_(&device), size_(size), use_(use) {
  const std::string what = "the " + name + " (" + inMegabytes(size) + ")";
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = size;
  info.usage = usage;
  VkBuffer buffer = VK_NULL_HANDLE;
  check(vkCreateBuffer(device.get(), &info, nullptr, &buffer), "make a buffer for " + what);
  buffer_ = {device.get(), buffer};

  VkMemoryRequirements requirements{};
  vkGetBufferMemoryRequirements(device.get(), buffer, &requirements);
  std::optional<std::uint32_t> type;
  for (std::size_t i = 0; i < memoryWishes.size() && !type; ++i) {
    type = findMemoryType(device, requirements.memoryTypeBits, memoryWishes[i]);
  }
  if (!type)
    throw Error(ExitCode::kDevice,
                device.description().name + " has no memory of the kind that is needed for " + what);

  VkMemoryAllocateInfo allocation{};
  allocation.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  allocation.allocationSize = requirements.size;
  allocation.memoryTypeIndex = *type;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  check(vkAllocateMemory(device.get(), &allocation, nullptr, &memory), "get memory for " + what);
  memory_ = {device.get(), memory};
  check(vkBindBufferMemory(device.get(), buffer, memory, 0), "give memory to " + what);

  if ((device.memory().memoryTypes[*type].propertyFlags & kOnHost) == kOnHost) {
    void* address = nullptr;
    check(vkMapMemory(device.get(), memory, 0, VK_WHOLE_SIZE, 0, &address), "reach the memory of " + what);
    mapped_ = static_cast<std::byte*>(address);
    preferHugePages(mapped_, size);
  }
}

Buffer Buffer::shared(Device& device, const std::string& name, std::size_t size) {
  checkReach(device, name, BufferUse::kStorage, size);
  return {device,
          name,
          size,
          BufferUse::kStorage,
          VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
          std::array{kHostCached, kOnHost}};
}

Buffer Buffer::uploaded(Device& device, const std::string& name, BufferUse use,
                        std::span<const std::byte> content) {
  checkReach(device, name, use, content.size());
  const VkBufferUsageFlags usage = use == BufferUse::kTexels ? VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT
                                                             : VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  Buffer buffer(device, name, content.size(), use, usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                std::array{kOnDevice | kOnHost, kOnDevice, kOnHost});
  if (buffer.mapped_ != nullptr) {
    std::memcpy(buffer.mapped_, content.data(), content.size());
  } else {
    const Buffer staging(device, name, content.size(), BufferUse::kStorage, VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                         std::array{kOnHost});
    std::memcpy(staging.mapped_, content.data(), content.size());
    Submission copy(device);
    copy.submit([&](VkCommandBuffer commands) {
      const VkBufferCopy region{0, 0, content.size()};
      vkCmdCopyBuffer(commands, staging.get(), buffer.get(), 1, &region);
    });
    copy.wait();
  }
  if (use == BufferUse::kTexels) buffer.createView(name);
  return buffer;
}

void Buffer::createView(const std::string& name) {
  VkBufferViewCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
  info.buffer = buffer_.get();
  info.format = kTexelFormat;
  info.range = VK_WHOLE_SIZE;
  VkBufferView view = VK_NULL_HANDLE;
  check(vkCreateBufferView(device_->get(), &info, nullptr, &view),
        "make a view of the " + name + " (" + inMegabytes(size_) + ") for the shader");
  view_ = {device_->get(), view};
}

}  // namespace lavaray::vulkan
