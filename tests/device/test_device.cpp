#include "device/test_device.hpp"

#include <algorithm>
#include <cstdlib>

// Mesa's driver loses some small allocations. What the program loses of Vulkan's objects, the validation
// layer reports.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libvulkan_lvp.so\n";
}

namespace lavaray {
namespace {

// Never destroyed: once the driver is unloaded, what it lost cannot be told to be its own.
const vulkan::Instance& testInstance() {
  static const auto* instance = new vulkan::Instance;
  return *instance;
}

}  // namespace

vulkan::Device& testDevice() {
  const char* choice = std::getenv("LAVARAY_TEST_DEVICE");
  static auto* device =
      new vulkan::Device(vulkan::chooseDevice(testInstance(), choice != nullptr ? choice : ""));
  return *device;
}

bool isLavapipe() {
  return testDevice().description().name.find("llvmpipe") != std::string::npos;
}

vulkan::Device* openDevice(const std::string& name) {
  const std::vector<vulkan::DeviceDescription> devices = vulkan::listDevices(testInstance());
  const auto device = std::find_if(devices.begin(), devices.end(), [&](const auto& description) {
    return description.usable && description.name.find(name) != std::string::npos;
  });
  return device == devices.end() ? nullptr : new vulkan::Device(*device);
}

}  // namespace lavaray
