#pragma once

#include <functional>
#include <utility>

#include "vulkan/loader.hpp"

namespace lavaray::vulkan {

// Owns a Vulkan handle that belongs to a device; move-only. `destroy` points to the function pointer, which
// is unknown until the loader is open: Handle<VkFence, &vkDestroyFence>.
template <typename Type, auto destroy>
class Handle {
 public:
  Handle() = default;
  Handle(VkDevice device, Type handle) : device_(device), handle_(handle) {}
  Handle(Handle&& other) noexcept
      : device_(other.device_), handle_(std::exchange(other.handle_, Type{VK_NULL_HANDLE})) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Handle() {
    if (handle_ != VK_NULL_HANDLE) (*destroy)(device_, handle_, nullptr);
  }
  [[nodiscard]] Type get() const { return handle_; }

 private:
  VkDevice device_ = VK_NULL_HANDLE;
  Type handle_ = VK_NULL_HANDLE;
};

}  // namespace lavaray::vulkan
