// A real Vulkan driver, of which one function fails. The environment says which: LAVARAY_DRIVER is the real
// driver's library, LAVARAY_FAILING_FUNCTION the function's name, LAVARAY_RESULT what it returns, as a
// number.
#include <dlfcn.h>
#include <vulkan/vk_icd.h>
#include <vulkan/vulkan.h>

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

template <typename Function>
Function realFunction(const char* name) {
  static void* driver = dlopen(std::getenv("LAVARAY_DRIVER"), RTLD_NOW | RTLD_LOCAL);
  if (driver == nullptr) std::abort();
  return reinterpret_cast<Function>(dlsym(driver, name));
}

// In place of a function with other parameters, which it leaves alone: that works where the caller clears
// them away, as it does on every machine with a Vulkan driver of 64 bits.
VKAPI_ATTR VkResult VKAPI_CALL fail() {
  static const auto result = static_cast<VkResult>(std::atoi(std::getenv("LAVARAY_RESULT")));
  return result;
}

PFN_vkGetDeviceProcAddr realDeviceFunction = nullptr;

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceFunction(VkDevice device, const char* name) {
  if (variable("LAVARAY_FAILING_FUNCTION") == name) return reinterpret_cast<PFN_vkVoidFunction>(fail);
  return realDeviceFunction(device, name);
}

}  // namespace

extern "C" {

VKAPI_ATTR __attribute__((visibility("default"))) VkResult VKAPI_CALL
vk_icdNegotiateLoaderICDInterfaceVersion(std::uint32_t* version) {
  return realFunction<PFN_vkNegotiateLoaderICDInterfaceVersion>("vk_icdNegotiateLoaderICDInterfaceVersion")(
      version);
}

VKAPI_ATTR __attribute__((visibility("default"))) PFN_vkVoidFunction VKAPI_CALL
vk_icdGetInstanceProcAddr(VkInstance instance, const char* name) {
  const std::string_view wanted = name;
  if (variable("LAVARAY_FAILING_FUNCTION") == wanted) return reinterpret_cast<PFN_vkVoidFunction>(fail);
  static const auto real = realFunction<PFN_vkGetInstanceProcAddr>("vk_icdGetInstanceProcAddr");
  const PFN_vkVoidFunction function = real(instance, name);
  if (wanted != "vkGetDeviceProcAddr" || function == nullptr) return function;
  realDeviceFunction = reinterpret_cast<PFN_vkGetDeviceProcAddr>(function);
  return reinterpret_cast<PFN_vkVoidFunction>(getDeviceFunction);
}

}  // extern "C"
