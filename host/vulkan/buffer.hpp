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

inline constexpr std::size_t kTexelBytes = 16;

// A buffer with its memory. `name` stands in error messages.
class Buffer {
 public:
  // A storage buffer that the host reads and writes through bytes().
  static Buffer shared(Device& device, const std::string& name, std::size_t size);
  // A buffer that the device reads, filled with `content`, which is not empty; in the device's own memory.
  // Throws Error(kDevice) naming size and limit where it is more than a shader can reach.
  static Buffer uploaded(Device& device, const std::string& name, BufferUse use,
                         std::span<const std::byte> content);

  [[nodiscard]] VkBuffer get() const { return buffer_.get(); }
  [[nodiscard]] VkBufferView view() const { return view_.get(); }  // of kTexels
  [[nodiscard]] BufferUse use() const { return use_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  // Where the host sees the buffer; null where it does not.
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
