#pragma once

#include <functional>
#include <string>
#include <vector>

#include "vulkan/loader.hpp"

namespace lavaray::vulkan {

// What the validation layer complains of; any thread may call it.
using OnMessage = std::function<void(const std::string&)>;

// The Vulkan instance, of which there is one at a time.
class Instance {
 public:
  // With `onMessage` it runs under the Khronos validation layer. Throws Error(kDevice), saying why, if there
  // is no loader, no device, or no validation layer to validate with. If a broken manifest keeps the loader
  // from a driver that works, uses that driver and warns.
  explicit Instance(OnMessage onMessage = {});
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  [[nodiscard]] VkInstance get() const { return instance_; }
  [[nodiscard]] bool isValidated() const { return onMessage_ != nullptr; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  VkResult open();
  VkResult create();
  void close();
  void createMessenger(const VkDebugUtilsMessengerCreateInfoEXT& info);

  OnMessage onMessage_;
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
