// A Vulkan driver that fails, in the way that its file is called: copies of this library under several names
// are several drivers. The real loader loads it.
//   no-memory.so, no-start.so   vkCreateInstance fails so
//   no-terms.so                 does not agree on the interface with the loader
//   no-device.so                has no device
//   no-list.so                  cannot list its devices
//   old.so                      has a device, of Vulkan 1.0
//   crash.so                    ends the process
#include <dlfcn.h>
#include <vulkan/vk_icd.h>
#include <vulkan/vulkan.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace {

// The loader writes a pointer to the front of each object that it gets.
struct Object {
  VK_LOADER_DATA loaderData{ICD_LOADER_MAGIC};
};

Object instanceObject;
Object deviceObject;

std::string fault() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<void*>(&fault), &info) == 0) std::abort();
  const std::string_view path = info.dli_fname;
  const std::string_view name = path.substr(path.find_last_of('/') + 1);
  return std::string(name.substr(0, name.find('.')));
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* /*info*/,
                                              const VkAllocationCallbacks* /*allocator*/,
                                              VkInstance* instance) {
  if (fault() == "no-memory") return VK_ERROR_OUT_OF_HOST_MEMORY;
  if (fault() == "no-start") return VK_ERROR_INITIALIZATION_FAILED;
  if (fault() == "crash") std::abort();
  *instance = reinterpret_cast<VkInstance>(&instanceObject);
  return VK_SUCCESS;
}

VKAPI_ATTR void VKAPI_CALL destroyInstance(VkInstance /*instance*/,
                                           const VkAllocationCallbacks* /*allocator*/) {}

VKAPI_ATTR VkResult VKAPI_CALL enumerateExtensions(const char* /*layer*/, std::uint32_t* count,
                                                   VkExtensionProperties* /*properties*/) {
  *count = 0;
  return VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL enumerateDevices(VkInstance /*instance*/, std::uint32_t* count,
                                                VkPhysicalDevice* devices) {
  if (fault() == "no-list") return VK_ERROR_INITIALIZATION_FAILED;
  if (fault() != "old") {
    *count = 0;
    return VK_SUCCESS;
  }
  if (devices != nullptr && *count > 0) devices[0] = reinterpret_cast<VkPhysicalDevice>(&deviceObject);
  *count = 1;
  return VK_SUCCESS;
}

VKAPI_ATTR void VKAPI_CALL getProperties(VkPhysicalDevice /*device*/,
                                         VkPhysicalDeviceProperties* properties) {
  *properties = {};
  properties->apiVersion = VK_API_VERSION_1_0;
  properties->deviceType = VK_PHYSICAL_DEVICE_TYPE_OTHER;
  std::strcpy(properties->deviceName, "Old Device");
}

VKAPI_ATTR VkResult VKAPI_CALL enumerateDeviceExtensions(VkPhysicalDevice /*device*/, const char* layer,
                                                         std::uint32_t* count,
                                                         VkExtensionProperties* properties) {
  return enumerateExtensions(layer, count, properties);
}

// For whatever else the loader wants to be there; nothing calls it.
VKAPI_ATTR void VKAPI_CALL isNeverCalled() {
  std::abort();
}

}  // namespace

extern "C" {

VKAPI_ATTR __attribute__((visibility("default"))) VkResult VKAPI_CALL
vk_icdNegotiateLoaderICDInterfaceVersion(std::uint32_t* version) {
  if (fault() == "no-terms") return VK_ERROR_INCOMPATIBLE_DRIVER;
  *version = *version < 5 ? *version : 5;
  return VK_SUCCESS;
}

VKAPI_ATTR __attribute__((visibility("default"))) PFN_vkVoidFunction VKAPI_CALL
vk_icdGetInstanceProcAddr(VkInstance instance, const char* name) {
  const std::string_view wanted = name;
  if (wanted == "vkCreateInstance") return reinterpret_cast<PFN_vkVoidFunction>(createInstance);
  if (wanted == "vkEnumerateInstanceExtensionProperties") {
    return reinterpret_cast<PFN_vkVoidFunction>(enumerateExtensions);
  }
  if (instance == VK_NULL_HANDLE) return nullptr;  // vkEnumerateInstanceVersion, too, as in Vulkan 1.0
  if (wanted == "vkDestroyInstance") return reinterpret_cast<PFN_vkVoidFunction>(destroyInstance);
  if (wanted == "vkEnumeratePhysicalDevices") return reinterpret_cast<PFN_vkVoidFunction>(enumerateDevices);
  if (wanted == "vkGetPhysicalDeviceProperties") return reinterpret_cast<PFN_vkVoidFunction>(getProperties);
  if (wanted == "vkEnumerateDeviceExtensionProperties") {
    return reinterpret_cast<PFN_vkVoidFunction>(enumerateDeviceExtensions);
  }
  if (wanted.ends_with("KHR") || wanted.ends_with("EXT")) return nullptr;
  return reinterpret_cast<PFN_vkVoidFunction>(isNeverCalled);
}

}  // extern "C"
