#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "vulkan/device.hpp"

namespace lavaray::vulkan {

enum class BufferUse {
  kStorage,  // a storage buffer
  kTexels,   // read through a view of RGBA32_UINT texels
};

VkDescriptorType descriptorType(BufferUse use);

inline constexpr std::size_t kTexelBytes = 16;

// A buffer and its memory. `name` is what error messages call it.
class Buffer {
 public:
  // A storage buffer, or one to copy into, that the host reads and writes through bytes().
  static Buffer shared(Device& device, const std::string& name, std::size_t size);
  // A buffer for the device to read, in the device's own memory, filled with `content`, which must not be
  // empty. Throws Error(kDevice) naming size and limit if it is more than a shader can reach.
  static Buffer uploaded(Device& device, const std::string& name, BufferUse use,
                         std::span<const std::byte> content);

  [[nodiscard]] VkBuffer get() const { return buffer_.get(); }
  [[nodiscard]] VkBufferView view() const { return view_.get(); }  // of kTexels
  [[nodiscard]] BufferUse use() const { return use_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  // The buffer as the host sees it; null if it does not.
  [[nodiscard]] std::byte* bytes() const { return mapped_; }

 private:
  Buffer(Device& device, const std::string& name, std::size_t size, BufferUse use, VkBufferUsageFlags usage,
         std::span<const VkMemoryPropertyFlags> memoryWishes);
  void createView(const std::string& name);

  Device* device_;
  std::size_t size_;
  BufferUse use_;
  Handle<VkDeviceMemory, &vkFreeMemory> memory_;  // outlives the buffer that is bound to it
  Handle<VkBuffer, &vkDestroyBuffer> buffer_;
  Handle<VkBufferView, &vkDestroyBufferView> view_;
  std::byte* mapped_ = nullptr;
};

}  // namespace lavaray::vulkan
