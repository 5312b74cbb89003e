#include "vulkan/loader.hpp"

#include <dlfcn.h>

#include <mutex>

#include "base/errors.hpp"

namespace lavaray::vulkan {

PFN_vkGetInstanceProcAddr vkGetInstanceProcAddr = nullptr;
#define LAVARAY_DEFINE(name) PFN_##name name = nullptr;
LAVARAY_GLOBAL_FUNCTIONS(LAVARAY_DEFINE)
LAVARAY_INSTANCE_FUNCTIONS(LAVARAY_DEFINE)
#undef LAVARAY_DEFINE

namespace {

// Fetches one function into the pointer of its name.
template <typename Function>
void fetch(VkInstance instance, const char* name, Function& function) {
  function = reinterpret_cast<Function>(vkGetInstanceProcAddr(instance, name));
  if (function == nullptr) {
    throw Error(ExitCode::kDevice,
                "the Vulkan loader or the driver is too old; install libvulkan1 and mesa-vulkan-drivers for "
                "Vulkan 1.2 or later");
  }
}

// What happened, and what can be done about it.
const char* meaning(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return "the machine has no memory left; a smaller scene or image needs less";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    case VK_ERROR_OUT_OF_POOL_MEMORY:
    case VK_ERROR_FRAGMENTED_POOL:
    case VK_ERROR_FRAGMENTATION:
    case VK_ERROR_TOO_MANY_OBJECTS:
      return "the device has no memory left; a smaller scene needs less, another --device may have more";
    case VK_ERROR_INITIALIZATION_FAILED:
      return "the driver could not start; is all of it installed, and is there memory for it?";
    case VK_ERROR_DEVICE_LOST:
      return "the device has stopped working; render again, or on another --device";
    case VK_ERROR_MEMORY_MAP_FAILED:
      return "the program cannot see the device's memory; is the machine's memory full?";
    case VK_ERROR_LAYER_NOT_PRESENT:
      return "a Vulkan layer that is asked for is not installed; install it, or ask for none";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
    case VK_ERROR_FEATURE_NOT_PRESENT:
    case VK_ERROR_FORMAT_NOT_SUPPORTED:
      return "the driver lacks what is needed; install a newer one, or choose another --device";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return "the driver does not know Vulkan 1.2; install a newer one, such as mesa-vulkan-drivers";
    case VK_ERROR_INVALID_SHADER_NV:
      return "the driver does not understand the shader; install a newer one, or choose another --device";
    case VK_NOT_READY:
    case VK_TIMEOUT:
      return "the device did not answer in time; is it busy?";
    default:
      return "the driver says no more than that it failed; a newer one, another --device or more memory may "
             "help";
  }
}

}  // namespace

void loadGlobalFunctions() {
  static std::once_flag once;
  std::call_once(once, [] {
    // Never closed: drivers do not survive being unloaded and loaded again.
    void* library = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
      throw Error(ExitCode::kDevice,
                  "the Vulkan loader libvulkan.so.1 cannot be opened; install the packages libvulkan1 and "
                  "mesa-vulkan-drivers");
    }
    vkGetInstanceProcAddr =
        reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(library, "vkGetInstanceProcAddr"));
    if (vkGetInstanceProcAddr == nullptr) {
      throw Error(ExitCode::kDevice,
                  "libvulkan.so.1 is not a Vulkan loader; reinstall the package libvulkan1");
    }
#define LAVARAY_FETCH(name) fetch(VK_NULL_HANDLE, #name, name);
    LAVARAY_GLOBAL_FUNCTIONS(LAVARAY_FETCH)
#undef LAVARAY_FETCH
  });
}

void loadInstanceFunctions(VkInstance instance) {
#define LAVARAY_FETCH(name) fetch(instance, #name, name);
  LAVARAY_INSTANCE_FUNCTIONS(LAVARAY_FETCH)
#undef LAVARAY_FETCH
}

std::string failureOf(VkResult result, const std::string& action) {
  return "cannot " + action + ": " + meaning(result);
}

void check(VkResult result, const std::string& action) {
  if (result != VK_SUCCESS) throw Error(ExitCode::kDevice, failureOf(result, action));
}

}  // namespace lavaray::vulkan
