#pragma once

#include <string>

#include "vulkan/loader.hpp"

namespace lavaray::vulkan {

// `VK_ERROR_DEVICE_LOST`, or `VkResult -424242` for one that is not known here.
std::string resultName(VkResult result);

// `cannot <action>: <what the result means, and what may help> (<the result's name>)`. The action is in a
// user's words, and names the object and, where it has one, its size.
std::string failureOf(VkResult result, const std::string& action);

// Throws Error(kDevice) with that unless `result` is VK_SUCCESS.
void check(VkResult result, const std::string& action);

}  // namespace lavaray::vulkan
