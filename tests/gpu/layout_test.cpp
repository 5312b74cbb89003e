// The layouts of shaders/interface.h, proved at run time.
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "core/errors.hpp"
#include "gpu/test_device.hpp"
#include "layoutProbeSpirv.spv.h"
#include "render/scene_buffers.hpp"
#include "shaders/probe.h"
#include "vulkan/compute.hpp"

namespace lavaray {
namespace {

// Numbers words 1.0 and up in steps of an ulp: distinct, and no float that a driver may change.
class Counter {
 public:
  template <typename Struct>
  Struct fill() {
    Struct result;
    std::array<std::uint32_t, sizeof(Struct) / 4> words;
    for (std::uint32_t& word : words) word = next_++;
    std::memcpy(&result, words.data(), sizeof result);
    return result;
  }

 private:
  std::uint32_t next_ = 0x3F800000U;
};

template <typename Struct>
void append(std::vector<std::uint32_t>& words, const Struct& value) {
  std::array<std::uint32_t, sizeof(Struct) / 4> valueWords;
  std::memcpy(valueWords.data(), &value, sizeof value);
  words.insert(words.end(), valueWords.begin(), valueWords.end());
}

TEST(Layout, IsTheSameOnHostAndDevice) {
  Counter counter;
  GpuScene scene;
  const auto fillTwo = [&]<typename Struct>(std::vector<Struct>& array) {
    array.push_back(counter.fill<Struct>());
    array.push_back(counter.fill<Struct>());
  };
  fillTwo(scene.nodes);
  fillTwo(scene.primitives);
  fillTwo(scene.trianglePlanes);
  fillTwo(scene.cornerNormals);
  fillTwo(scene.planes);
  fillTwo(scene.lights);
  fillTwo(scene.materials);
  const auto constants = counter.fill<gpu::DispatchConstants>();

  std::vector<std::uint32_t> expected;
  append(expected, scene.nodes[1]);
  append(expected, scene.primitives[1]);
  append(expected, scene.trianglePlanes[1]);
  append(expected, scene.cornerNormals[1]);
  append(expected, scene.planes[1]);
  append(expected, scene.lights[1]);
  append(expected, scene.materials[1]);
  append(expected, constants);

  vulkan::Device& device = testDevice();
  std::vector<vulkan::Buffer> buffers = uploadScene(device, scene);
  buffers.push_back(
      vulkan::Buffer::shared(device, "written", 2 * sizeof(gpu::Pixel) + 2 * sizeof(gpu::DispatchStatus)));
  buffers.push_back(vulkan::Buffer::shared(device, "words", 4 * expected.size()));
  vulkan::ComputeShader shader(device, layoutProbeSpirv, specializationFor(scene, false), buffers,
                               sizeof constants);
  shader.dispatch(1, std::as_bytes(std::span(&constants, 1)));

  std::vector<std::uint32_t> words(expected.size());
  std::memcpy(words.data(), buffers[gpu::kBindingProbeOut].bytes(), 4 * words.size());
  EXPECT_EQ(words, expected);

  const std::byte* written = buffers[gpu::kBindingProbeIn].bytes();
  gpu::Pixel pixel{};
  std::memcpy(&pixel, written + sizeof(gpu::Pixel), sizeof pixel);
  EXPECT_EQ(pixel.color, glm::vec3(1, 2, 3));
  EXPECT_EQ(pixel.nextLight, 4U);
  gpu::DispatchStatus status{};
  std::memcpy(&status, written + 2 * sizeof(gpu::Pixel) + sizeof status, sizeof status);
  EXPECT_EQ(status.unfinished, 5U);
  EXPECT_EQ(status.stuck, 6U);
  EXPECT_EQ(status.shadowRays, 7U);
}

TEST(Buffer, OverTheDevicesReachNamesTheNumberAndTheLimit) {
  vulkan::Device& device = testDevice();
  const std::size_t limit = device.limits().storageBufferRange;
  if (limit > (std::size_t{1} << 31U)) GTEST_SKIP() << "the device's limit is over 2 GiB";
  const std::vector<std::byte> content(limit + 16);
  try {
    vulkan::Buffer::uploaded(device, "materials", vulkan::BufferUse::kStorage, content);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), ExitCode::kDevice);
    const std::string message = error.what();
    EXPECT_NE(message.find(std::to_string(limit + 16)), std::string::npos) << message;
    EXPECT_NE(message.find(std::to_string(limit)), std::string::npos) << message;
    EXPECT_NE(message.find("materials"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace lavaray
