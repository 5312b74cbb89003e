#pragma once

#include "vulkan/device.hpp"

namespace lavaray {

// The device that all tests of a process share; the environment variable LAVARAY_TEST_DEVICE chooses it as
// --device does.
vulkan::Device& testDevice();

}  // namespace lavaray
