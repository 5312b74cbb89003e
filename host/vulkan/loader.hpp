#pragma once

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan.h>

// The Vulkan loader is opened at run time, not linked, so that a machine without it is told which package to
// install, and can still do everything that needs no device.

namespace lavaray::vulkan {

// clang-format off
#define LAVARAY_GLOBAL_FUNCTIONS(X) \
  X(vkCreateInstance) X(vkEnumerateInstanceLayerProperties) X(vkEnumerateInstanceExtensionProperties)

#define LAVARAY_INSTANCE_FUNCTIONS(X) \
  X(vkDestroyInstance) X(vkEnumeratePhysicalDevices) X(vkGetPhysicalDeviceProperties) \
  X(vkGetPhysicalDeviceProperties2) X(vkGetPhysicalDeviceMemoryProperties) \
  X(vkGetPhysicalDeviceQueueFamilyProperties) X(vkCreateDevice) \
  X(vkDestroyDevice) X(vkGetDeviceQueue) X(vkDeviceWaitIdle) X(vkCreateBuffer) X(vkDestroyBuffer) \
  X(vkGetBufferMemoryRequirements) X(vkAllocateMemory) X(vkFreeMemory) X(vkBindBufferMemory) X(vkMapMemory) \
  X(vkCreateBufferView) X(vkDestroyBufferView) X(vkCreateShaderModule) X(vkDestroyShaderModule) \
  X(vkCreateDescriptorSetLayout) X(vkDestroyDescriptorSetLayout) X(vkCreateDescriptorPool) \
  X(vkDestroyDescriptorPool) X(vkAllocateDescriptorSets) X(vkUpdateDescriptorSets) X(vkCreatePipelineLayout) \
  X(vkDestroyPipelineLayout) X(vkCreateComputePipelines) X(vkDestroyPipeline) X(vkCreateCommandPool) \
  X(vkDestroyCommandPool) X(vkAllocateCommandBuffers) X(vkBeginCommandBuffer) X(vkEndCommandBuffer) \
  X(vkCmdBindPipeline) X(vkCmdBindDescriptorSets) X(vkCmdPushConstants) X(vkCmdDispatch) \
  X(vkCmdPipelineBarrier) X(vkCmdCopyBuffer) X(vkQueueSubmit) X(vkCreateFence) X(vkDestroyFence) \
  X(vkWaitForFences) X(vkResetFences) X(vkCreateQueryPool) X(vkDestroyQueryPool) X(vkCmdResetQueryPool) \
  X(vkCmdWriteTimestamp) X(vkCmdCopyQueryPoolResults)
// clang-format on

// Named as in the specification, so that a call reads as it does everywhere.
extern PFN_vkGetInstanceProcAddr vkGetInstanceProcAddr;
#define LAVARAY_DECLARE(name) extern PFN_##name name;
LAVARAY_GLOBAL_FUNCTIONS(LAVARAY_DECLARE)
LAVARAY_INSTANCE_FUNCTIONS(LAVARAY_DECLARE)
#undef LAVARAY_DECLARE

// Opens the loader and fetches the functions that need no instance; calling it again does nothing. Throws
// Error(kDevice) naming the package to install if there is no loader.
void loadGlobalFunctions();

// Fetches all other functions. The program has one instance at a time.
void loadInstanceFunctions(VkInstance instance);

}  // namespace lavaray::vulkan
