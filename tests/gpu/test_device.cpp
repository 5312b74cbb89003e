#include "gpu/test_device.hpp"

#include <cstdlib>

namespace lavaray {

vulkan::Device& testDevice() {
  static const vulkan::Instance instance(false);
  const char* choice = std::getenv("LAVARAY_TEST_DEVICE");
  static vulkan::Device device(vulkan::chooseDevice(instance, choice != nullptr ? choice : ""));
  return device;
}

}  // namespace lavaray
