#pragma once

#include <string>

#include "vulkan/driver_survey.hpp"
#include "vulkan/loader.hpp"

namespace lavaray::vulkan {

// Why there is no device, in words for a user. `result` is what the loader answered.
std::string explainNoDevice(const DriverSurvey& survey, VkResult result);

// The same if there are devices, `listing`, but none can be used.
std::string explainUnusableDevices(const DriverSurvey& survey, const std::string& listing);

}  // namespace lavaray::vulkan
