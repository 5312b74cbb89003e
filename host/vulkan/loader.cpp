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

// Fetches a function into the pointer that has its name.
template <typename Function>
void fetch(VkInstance instance, const char* name, Function& function) {
  function = reinterpret_cast<Function>(vkGetInstanceProcAddr(instance, name));
  if (function == nullptr) {
    throw Error(ExitCode::kDevice,
                "the Vulkan loader or the driver is too old; install libvulkan1 and mesa-vulkan-drivers for "
                "Vulkan 1.2 or later");
  }
}

}  // namespace

void loadGlobalFunctions() {
  static std::once_flag once;
  std::call_once(once, [] {
    // Never closed: drivers do not survive being unloaded and reloaded.
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

}  // namespace lavaray::vulkan
