#pragma once

#include <string>

#include "vulkan/device.hpp"

namespace lavaray {

// The device that all tests of a process share; the environment variable LAVARAY_TEST_DEVICE chooses it as
// --device does.
vulkan::Device& testDevice();

// Whether that is lavapipe, which does more than Vulkan asks for: it rounds quotients and roots correctly and
// keeps denormal numbers. Tests may demand exactness of it that others need not have.
bool isLavapipe();

// Another device, whose name contains this; nothing where there is none. Each call opens it anew, and leaves
// it open.
vulkan::Device* openDevice(const std::string& name);

}  // namespace lavaray
