#include "vulkan/result.hpp"

#include <algorithm>
#include <iterator>

#include "base/errors.hpp"

namespace lavaray::vulkan {
namespace {

struct KnownResult {
  VkResult result;
  const char* name;
  const char* meaning;  // what happened; what can be done about it
};

constexpr const char* kNoDeviceMemory =
    "the device has no memory left; a smaller scene needs less, another --device may have more";
constexpr const char* kLacking =
    "the driver lacks what is needed; install a newer one, or choose another --device";
constexpr const char* kLate = "the device did not answer in time; is it busy?";
constexpr const char* kUnexplained =
    "the driver says no more than that it failed; a newer one, another --device or more memory may help";

#define LAVARAY_RESULT(result) result, #result
// All that the functions which the program calls can return. A table, since Debian's Vulkan headers lack
// vk_enum_string_helper.h.
constexpr KnownResult kResults[] = {
    {LAVARAY_RESULT(VK_NOT_READY), kLate},
    {LAVARAY_RESULT(VK_TIMEOUT), kLate},
    {LAVARAY_RESULT(VK_INCOMPLETE), kUnexplained},
    {LAVARAY_RESULT(VK_ERROR_OUT_OF_HOST_MEMORY),
     "the machine has no memory left; a smaller scene or image needs less"},
    {LAVARAY_RESULT(VK_ERROR_OUT_OF_DEVICE_MEMORY), kNoDeviceMemory},
    {LAVARAY_RESULT(VK_ERROR_INITIALIZATION_FAILED),
     "the driver could not start; is all of it installed, and is there memory for it?"},
    {LAVARAY_RESULT(VK_ERROR_DEVICE_LOST),
     "the device has stopped working; render again, or on another --device"},
    {LAVARAY_RESULT(VK_ERROR_MEMORY_MAP_FAILED),
     "the program cannot see the device's memory; is the machine's memory full?"},
    {LAVARAY_RESULT(VK_ERROR_LAYER_NOT_PRESENT),
     "a Vulkan layer that is asked for is not installed; install it, or ask for none"},
    {LAVARAY_RESULT(VK_ERROR_EXTENSION_NOT_PRESENT), kLacking},
    {LAVARAY_RESULT(VK_ERROR_FEATURE_NOT_PRESENT), kLacking},
    {LAVARAY_RESULT(VK_ERROR_INCOMPATIBLE_DRIVER),
     "the driver does not know Vulkan 1.2; install a newer one, such as mesa-vulkan-drivers"},
    {LAVARAY_RESULT(VK_ERROR_TOO_MANY_OBJECTS), kNoDeviceMemory},
    {LAVARAY_RESULT(VK_ERROR_FORMAT_NOT_SUPPORTED), kLacking},
    {LAVARAY_RESULT(VK_ERROR_FRAGMENTED_POOL), kNoDeviceMemory},
    {LAVARAY_RESULT(VK_ERROR_UNKNOWN), kUnexplained},
    {LAVARAY_RESULT(VK_ERROR_OUT_OF_POOL_MEMORY), kNoDeviceMemory},
    {LAVARAY_RESULT(VK_ERROR_FRAGMENTATION), kNoDeviceMemory},
    {LAVARAY_RESULT(VK_ERROR_INVALID_EXTERNAL_HANDLE), kUnexplained},
    {LAVARAY_RESULT(VK_ERROR_INVALID_OPAQUE_CAPTURE_ADDRESS), kUnexplained},
    {LAVARAY_RESULT(VK_ERROR_INVALID_SHADER_NV),
     "the driver does not understand the shader; install a newer one, or choose another --device"},
    {LAVARAY_RESULT(VK_ERROR_VALIDATION_FAILED_EXT), kUnexplained},
};
#undef LAVARAY_RESULT

const KnownResult* find(VkResult result) {
  const auto* known = std::ranges::find(kResults, result, &KnownResult::result);
  return known != std::end(kResults) ? known : nullptr;
}

}  // namespace

std::string resultName(VkResult result) {
  const KnownResult* known = find(result);
  return known != nullptr ? known->name : "VkResult " + std::to_string(static_cast<int>(result));
}

std::string failureOf(VkResult result, const std::string& action) {
  const KnownResult* known = find(result);
  return "cannot " + action + ": " + (known != nullptr ? known->meaning : kUnexplained) + " (" +
         resultName(result) + ')';
}

void check(VkResult result, const std::string& action) {
  if (result != VK_SUCCESS) throw Error(ExitCode::kDevice, failureOf(result, action));
}

}  // namespace lavaray::vulkan
