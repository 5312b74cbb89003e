// What a user is told where a Vulkan call fails.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "base/errors.hpp"
#include "vulkan/result.hpp"

namespace lavaray::vulkan {
namespace {

std::string messageOf(VkResult result) {
  try {
    check(result, "paint the wall");
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), ExitCode::kDevice);
    return error.what();
  }
  return {};
}

TEST(VulkanMessages, SayNothingOfSuccess) {
  EXPECT_EQ(messageOf(VK_SUCCESS), "");
}

// Of each result that a function of the program can return, and of those that are yet to be invented.
TEST(VulkanMessages, SayInWordsWhatHappenedAndWhatMayHelp) {
  const std::string beginning = "cannot paint the wall: ";
  std::set<std::string> meanings;
  for (const VkResult result : {VK_NOT_READY,
                                VK_TIMEOUT,
                                VK_ERROR_OUT_OF_HOST_MEMORY,
                                VK_ERROR_OUT_OF_DEVICE_MEMORY,
                                VK_ERROR_INITIALIZATION_FAILED,
                                VK_ERROR_DEVICE_LOST,
                                VK_ERROR_MEMORY_MAP_FAILED,
                                VK_ERROR_LAYER_NOT_PRESENT,
                                VK_ERROR_EXTENSION_NOT_PRESENT,
                                VK_ERROR_FEATURE_NOT_PRESENT,
                                VK_ERROR_INCOMPATIBLE_DRIVER,
                                VK_ERROR_TOO_MANY_OBJECTS,
                                VK_ERROR_FORMAT_NOT_SUPPORTED,
                                VK_ERROR_FRAGMENTED_POOL,
                                VK_ERROR_UNKNOWN,
                                VK_ERROR_OUT_OF_POOL_MEMORY,
                                VK_ERROR_FRAGMENTATION,
                                VK_ERROR_INVALID_EXTERNAL_HANDLE,
                                VK_ERROR_INVALID_OPAQUE_CAPTURE_ADDRESS,
                                VK_ERROR_INVALID_SHADER_NV,
                                static_cast<VkResult>(-424242)}) {
    const std::string message = messageOf(result);
    ASSERT_EQ(message.rfind(beginning, 0), 0U) << message;
    const std::string ending = " (" + resultName(result) + ")";
    ASSERT_TRUE(message.ends_with(ending)) << message;
    const std::string meaning =
        message.substr(beginning.size(), message.size() - beginning.size() - ending.size());
    EXPECT_GT(meaning.size(), 20U) << result;
    EXPECT_EQ(meaning.find("VK"), std::string::npos) << meaning;
    EXPECT_EQ(meaning.find('_'), std::string::npos) << meaning;
    EXPECT_NE(meaning.find_first_of(";?"), std::string::npos) << "says nothing of what may help: " << meaning;
    meanings.insert(meaning);
  }
  EXPECT_GT(meanings.size(), 8U);
}

TEST(VulkanMessages, NameTheResultAsTheSpecificationDoes) {
  EXPECT_EQ(resultName(VK_ERROR_OUT_OF_DEVICE_MEMORY), "VK_ERROR_OUT_OF_DEVICE_MEMORY");
  EXPECT_EQ(resultName(VK_ERROR_DEVICE_LOST), "VK_ERROR_DEVICE_LOST");
  EXPECT_EQ(resultName(VK_TIMEOUT), "VK_TIMEOUT");
  EXPECT_EQ(resultName(static_cast<VkResult>(-424242)), "VkResult -424242");
}

}  // namespace
}  // namespace lavaray::vulkan
