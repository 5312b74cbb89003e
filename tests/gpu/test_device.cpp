#include "gpu/test_device.hpp"

#include <cstdlib>

namespace lavaray {

vulkan::Device& testDevice() {
  // Never destroyed: Mesa loses 128 bytes when its driver is unloaded, which the leak sanitizer would report.
  static const auto* instance = new vulkan::Instance(false);
  const char* choice = std::getenv("LAVARAY_TEST_DEVICE");
  static auto* device = new vulkan::Device(vulkan::chooseDevice(*instance, choice != nullptr ? choice : ""));
  return *device;
}

}  // namespace lavaray
