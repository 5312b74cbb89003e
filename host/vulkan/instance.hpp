#pragma once

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "vulkan/loader.hpp"

namespace lavaray::vulkan {

// The Vulkan instance; with validation, under the Khronos layer, whose warnings and errors go to stderr and
// are counted.
class Instance {
 public:
  // Throws Error(kDevice), saying why, where there is no loader, no device, or no validation layer though it
  // is asked for. Where some driver works and a broken manifest keeps the loader from it, uses it and warns.
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
  int rank;            // the lower, the better a default
  bool usable;         // it has Vulkan 1.2 and a compute queue
};

std::vector<DeviceDescription> listDevices(const Instance& instance);

// Chooses by number or by part of the name, whatever its case; an empty choice is the best usable device.
// Throws Error(kDevice), listing the devices, where there is none, or the choice fits none or more than one.
DeviceDescription chooseDevice(const Instance& instance, const std::string& choice);

}  // namespace lavaray::vulkan
