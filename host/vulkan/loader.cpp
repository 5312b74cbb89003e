#include "vulkan/loader.hpp"

#include <dlfcn.h>

#include <mutex>

#include "core/errors.hpp"

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
    throw Error(ExitCode::kDevice, std::string("the Vulkan loader has no ") + name +
                                       "; install a newer libvulkan1 (Vulkan 1.2 or later)");
  }
}

const char* meaning(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return "out of memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "out of device memory";
    case VK_ERROR_INITIALIZATION_FAILED:
      return "the driver could not be initialised";
    case VK_ERROR_DEVICE_LOST:
      return "the device was lost";
    case VK_ERROR_MEMORY_MAP_FAILED:
      return "the memory could not be mapped";
    case VK_ERROR_LAYER_NOT_PRESENT:
      return "a layer is not installed";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
      return "an extension is not supported";
    case VK_ERROR_FEATURE_NOT_PRESENT:
      return "a feature is not supported";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return "no driver supports this version of Vulkan";
    case VK_TIMEOUT:
      return "the device did not answer in time";
    default:
      return "unexpected failure of the driver";
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

void check(VkResult result, const std::string& action) {
  if (result == VK_SUCCESS) return;
  throw Error(ExitCode::kDevice, "cannot " + action + ": " + meaning(result) + " (VkResult " +
                                     std::to_string(static_cast<int>(result)) + ")");
}

}  // namespace lavaray::vulkan
