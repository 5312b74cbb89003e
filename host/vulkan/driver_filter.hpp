#pragma once

#include <string>

namespace lavaray::vulkan {

// Why VK_LOADER_DRIVERS_SELECT or VK_LOADER_DRIVERS_DISABLE makes the loader leave out a driver, to be said
// after its manifest; empty where neither does.
std::string whyFilteredOut(const std::string& manifest);

}  // namespace lavaray::vulkan
