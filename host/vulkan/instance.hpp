#pragma once

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "vulkan/loader.hpp"

namespace lavaray::vulkan {

// The Vulkan instance. With validation it runs under the Khronos layer, whose warnings and errors are counted
// and go to stderr.
class Instance {
 public:
  // Throws Error(kDevice), saying why, if there is no loader, no device, or no validation layer to validate
  // with. If a broken manifest keeps the loader from a driver that works, uses that driver and warns.
  explicit Instance(bool validate);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  [[nodiscard]] VkInstance get() const { return instance_; }
  [[nodiscard]] int validationMessages() const { return validationMessages_; }
  std::vector<std::string> takeWarnings() { return std::exchange(warnings_, {}); }

 private:
  VkResult open(bool validate);
  VkResult create(bool validate);
  void close();
  void createMessenger(const VkDebugUtilsMessengerCreateInfoEXT& info);

  std::atomic<int> validationMessages_{0};
  std::vector<std::string> warnings_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

// A device as a user sees it, numbered as the driver lists them.
struct DeviceDescription {
  VkPhysicalDevice handle;
  std::string name;
  std::string kind;    // discrete GPU, integrated GPU, virtual GPU, CPU, other
  std::string driver;  // name and version
  int rank;            // lower is a better default
  bool usable;         // it has Vulkan 1.2 and a compute queue
  bool isCpu;
};

std::vector<DeviceDescription> listDevices(const Instance& instance);

// Chooses by number or by part of the name, ignoring case; an empty choice means the best usable device.
// Throws Error(kDevice), listing the devices, if there is none or the choice does not fit exactly one.
DeviceDescription chooseDevice(const Instance& instance, const std::string& choice);

}  // namespace lavaray::vulkan
