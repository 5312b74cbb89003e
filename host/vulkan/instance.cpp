#include "vulkan/instance.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <optional>
#include <span>
#include <utility>

#include "base/errors.hpp"
#include "vulkan/driver_survey.hpp"
#include "vulkan/loader_environment.hpp"
#include "vulkan/no_device.hpp"
#include "vulkan/result.hpp"

namespace lavaray::vulkan {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VkResult findValidationLayer() {
  std::uint32_t count = 0;
  VkResult result = vkEnumerateInstanceLayerProperties(&count, nullptr);
  if (result != VK_SUCCESS) return result;
  std::vector<VkLayerProperties> layers(count);
  result = vkEnumerateInstanceLayerProperties(&count, layers.data());
  if (result != VK_SUCCESS) return result;
  const bool isThere = std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
    return std::strcmp(layer.layerName, kValidationLayer) == 0;
  });
  if (isThere) return VK_SUCCESS;
  throw Error(ExitCode::kDevice, "there is no Vulkan validation layer; install vulkan-validationlayers");
}

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT /*severity*/,
                                         VkDebugUtilsMessageTypeFlagsEXT /*types*/,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* handler) {
  (*static_cast<OnMessage*>(handler))(data->pMessage);
  return VK_FALSE;
}

std::string kindOf(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return "discrete GPU";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return "integrated GPU";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return "virtual GPU";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return "CPU";
    default:
      return "other";
  }
}

int rankOf(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return 0;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return 1;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return 3;
    default:
      return 4;
  }
}

bool hasComputeQueue(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  return std::any_of(families.begin(), families.end(), [](const VkQueueFamilyProperties& family) {
    return (family.queueFlags & VK_QUEUE_COMPUTE_BIT) != 0;
  });
}

DeviceDescription describe(VkPhysicalDevice device) {
  VkPhysicalDeviceProperties first{};
  vkGetPhysicalDeviceProperties(device, &first);
  const bool isNew = first.apiVersion >= VK_API_VERSION_1_2;
  std::string driverName;
  if (isNew) {
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &driver;
    vkGetPhysicalDeviceProperties2(device, &properties);
    driverName = std::string(driver.driverName) + " " + driver.driverInfo;
  }
  return {device,
          first.deviceName,
          kindOf(first.deviceType),
          driverName,
          rankOf(first.deviceType),
          isNew && hasComputeQueue(device),
          first.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU};
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string listing(std::span<const DeviceDescription> devices) {
  std::string text;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    text += "\n  " + std::to_string(i) + ": " + devices[i].name + (devices[i].usable ? "" : " (not usable)");
  }
  return text;
}

// The device of that number, or all whose names contain the choice.
std::vector<DeviceDescription> matching(std::span<const DeviceDescription> devices,
                                        const std::string& choice) {
  if (std::all_of(choice.begin(), choice.end(), [](unsigned char c) { return std::isdigit(c) != 0; })) {
    const bool exists = choice.size() < 5 && std::stoul(choice) < devices.size();
    return exists ? std::vector{devices[std::stoul(choice)]} : std::vector<DeviceDescription>{};
  }
  std::vector<DeviceDescription> matches;
  for (const DeviceDescription& device : devices) {
    if (lower(device.name).find(lower(choice)) != std::string::npos) matches.push_back(device);
  }
  return matches;
}

}  // namespace

Instance::Instance(OnMessage onMessage) : onMessage_(std::move(onMessage)) {
  loadGlobalFunctions();
  VkResult result = open();
  if (result == VK_SUCCESS) return;
  const DriverSurvey survey = surveyDrivers();
  if (survey.canDoWithout()) {
    {
      const LoaderEnvironment sound(survey);
      result = open();
    }
    if (result == VK_SUCCESS) {
      for (const std::string& line : survey.lines(false)) warnings_.push_back(line + "; it is left out");
      return;
    }
  }
  throw Error(ExitCode::kDevice, explainNoDevice(survey, result));
}

Instance::~Instance() {
  close();
}

// Leaves no instance open unless it returns VK_SUCCESS, which means that there is a device.
VkResult Instance::open() {
  VkResult result = create();
  if (result != VK_SUCCESS) return result;
  std::uint32_t count = 0;
  result = vkEnumeratePhysicalDevices(instance_, &count, nullptr);
  if (result == VK_SUCCESS && count > 0) return VK_SUCCESS;
  close();
  return result == VK_SUCCESS ? VK_ERROR_INITIALIZATION_FAILED : result;
}

VkResult Instance::create() {
  if (isValidated()) {
    if (const VkResult result = findValidationLayer(); result != VK_SUCCESS) return result;
  }
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.pApplicationName = "lavaray";
  application.apiVersion = VK_API_VERSION_1_2;

  VkDebugUtilsMessengerCreateInfoEXT messenger{};
  messenger.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  messenger.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messenger.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  messenger.pfnUserCallback = onMessage;
  messenger.pUserData = &onMessage_;

  const char* extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &application;
  if (isValidated()) {
    info.pNext = &messenger;  // to hear messages about vkCreateInstance itself
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &kValidationLayer;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
  }
  const VkResult result = vkCreateInstance(&info, nullptr, &instance_);
  if (result != VK_SUCCESS) return result;
  loadInstanceFunctions(instance_);
  if (isValidated()) createMessenger(messenger);
  return VK_SUCCESS;
}

void Instance::close() {
  if (messenger_ != VK_NULL_HANDLE) {
    reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"))(instance_, messenger_, nullptr);
  }
  if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
  messenger_ = VK_NULL_HANDLE;
  instance_ = VK_NULL_HANDLE;
}

void Instance::createMessenger(const VkDebugUtilsMessengerCreateInfoEXT& info) {
  const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
  check(create(instance_, &info, nullptr, &messenger_), "listen to the validation layer");
}

std::vector<DeviceDescription> listDevices(const Instance& instance) {
  std::uint32_t count = 0;
  check(vkEnumeratePhysicalDevices(instance.get(), &count, nullptr), "list the Vulkan devices");
  std::vector<VkPhysicalDevice> handles(count);
  check(vkEnumeratePhysicalDevices(instance.get(), &count, handles.data()), "list the Vulkan devices");
  std::vector<DeviceDescription> devices;
  for (VkPhysicalDevice handle : handles) devices.push_back(describe(handle));
  return devices;
}

DeviceDescription chooseDevice(const Instance& instance, const std::string& choice) {
  const std::vector<DeviceDescription> devices = listDevices(instance);
  if (!choice.empty()) {
    const std::vector<DeviceDescription> matches = matching(devices, choice);
    if (matches.size() == 1 && matches[0].usable) return matches[0];
    throw Error(ExitCode::kDevice, "--device " + choice + " names " +
                                       (matches.empty()       ? "no device"
                                        : matches.size() == 1 ? "a device without Vulkan 1.2 compute"
                                                              : "several devices") +
                                       "; there are:" + listing(devices));
  }
  std::optional<DeviceDescription> best;
  for (const DeviceDescription& device : devices) {
    if (device.usable && (!best || device.rank < best->rank)) best = device;
  }
  if (!best) {
    throw Error(ExitCode::kDevice, explainUnusableDevices(surveyDrivers(), listing(devices)));
  }
  return *best;
}

}  // namespace lavaray::vulkan
