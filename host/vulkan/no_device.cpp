#include "vulkan/no_device.hpp"

#include <algorithm>
#include <vector>

#include "vulkan/driver_search.hpp"
#include "vulkan/result.hpp"

namespace lavaray::vulkan {
namespace {

constexpr std::size_t kMaxLoaderMessages = 3;

std::string below(const std::string& head, const std::vector<std::string>& lines) {
  if (lines.size() == 1) return head + ": " + lines[0];
  std::string text = head + ':';
  for (const std::string& line : lines) text += "\n  " + line;
  return text;
}

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + inQuotes(word);
  return text;
}

VKAPI_ATTR VkBool32 VKAPI_CALL keepMessage(VkDebugUtilsMessageSeverityFlagBitsEXT /*severity*/,
                                           VkDebugUtilsMessageTypeFlagsEXT /*types*/,
                                           const VkDebugUtilsMessengerCallbackDataEXT* data, void* messages) {
  auto& kept = *static_cast<std::vector<std::string>*>(messages);
  if (kept.size() < kMaxLoaderMessages) kept.emplace_back(data->pMessage);
  return VK_FALSE;
}

// Asks the loader once more, and listens. A last resort: its messages are about its own functions.
std::vector<std::string> loaderMessages() {
  std::vector<std::string> messages;
  VkDebugUtilsMessengerCreateInfoEXT messenger{};
  messenger.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  messenger.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT;
  messenger.pfnUserCallback = keepMessage;
  messenger.pUserData = &messages;
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pNext = &messenger;
  VkInstance instance = VK_NULL_HANDLE;
  if (vkCreateInstance(&info, nullptr, &instance) == VK_SUCCESS) {
    if (const auto destroy =
            reinterpret_cast<PFN_vkDestroyInstance>(vkGetInstanceProcAddr(instance, "vkDestroyInstance"))) {
      destroy(instance, nullptr);
    }
  }
  return messages;
}

}  // namespace

std::string explainNoDevice(const DriverSurvey& survey, VkResult result) {
  if (survey.drivers.empty()) {
    return "there is no Vulkan driver: none of the folders " + join(driverFolders()) +
           " holds the manifest of one; install mesa-vulkan-drivers";
  }
  const bool hasWorking =
      std::any_of(survey.drivers.begin(), survey.drivers.end(),
                  [](const SurveyedDriver& driver) { return driver.state == DriverState::kWorks; });
  if (!hasWorking) return below("no device can be used", survey.lines(true));
  const std::vector<std::string> broken = survey.lines(false);
  if (!broken.empty()) {
    return below("the Vulkan loader finds no driver, though one works, because of what is broken here",
                 broken);
  }
  std::string text = failureOf(result, "start Vulkan, though a driver works");
  for (const std::string& message : loaderMessages())
    text += "\n  the Vulkan loader says: " + inQuotes(message);
  return text;
}

std::string explainUnusableDevices(const DriverSurvey& survey, const std::string& listing) {
  const std::string text =
      "no device has what is needed, Vulkan 1.2 and a compute queue; there are:" + listing;
  const std::vector<std::string> broken = survey.lines(false);
  return broken.empty() ? text : below(text + "\nand what cannot be used", broken);
}

}  // namespace lavaray::vulkan
