#include "gpu/test_device.hpp"

#include <cstdlib>

// Mesa's driver loses some small allocations. What the program loses of Vulkan's objects, the validation
// layer reports.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libvulkan_lvp.so\n";
}

namespace lavaray {

vulkan::Device& testDevice() {
  // Never destroyed: once the driver is unloaded, what it lost cannot be told to be its own.
  static const auto* instance = new vulkan::Instance(false);
  const char* choice = std::getenv("LAVARAY_TEST_DEVICE");
  static auto* device = new vulkan::Device(vulkan::chooseDevice(*instance, choice != nullptr ? choice : ""));
  return *device;
}

}  // namespace lavaray
