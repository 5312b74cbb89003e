// The layouts of shaders/interface.h, proved at run time.
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "base/errors.hpp"
#include "device/shaders/probe.h"
#include "device/test_device.hpp"
#include "layoutProbeSpirv.spv.h"
#include "render/scene_buffers.hpp"
#include "render/variant.hpp"
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

// The arrays of layout_probe.comp's first buffer.
struct Shared {
  std::array<gpu::WorkItem, 2> items;
  std::array<gpu::WorkState, 2> states;
  std::array<gpu::WorkResult, 2> results;
  std::array<gpu::DispatchStatus, 2> statuses;
};

TEST(Layout, IsTheSameOnHostAndDevice) {
  Counter counter;
  GpuScene scene;
  const auto fillTwo = [&](auto& array) {
    using Struct = std::decay_t<decltype(array[0])>;
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
  const auto item = counter.fill<gpu::WorkItem>();
  const auto state = counter.fill<gpu::WorkState>();

  std::vector<std::uint32_t> expected;
  append(expected, scene.nodes[1]);
  append(expected, scene.primitives[1]);
  append(expected, scene.trianglePlanes[1]);
  append(expected, scene.cornerNormals[1]);
  append(expected, scene.planes[1]);
  append(expected, scene.lights[1]);
  append(expected, scene.materials[1]);
  append(expected, constants);
  append(expected, item);
  append(expected, state);

  vulkan::Device& device = testDevice();
  std::vector<vulkan::Buffer> buffers = uploadScene(device, scene);
  buffers.push_back(vulkan::Buffer::shared(device, "in and out", sizeof(Shared)));
  auto* shared = reinterpret_cast<Shared*>(buffers[gpu::kBindingProbeIn].bytes());
  shared->items[1] = item;
  shared->states[1] = state;
  buffers.push_back(vulkan::Buffer::shared(device, "words", 4 * expected.size()));
  vulkan::ComputeShader shader(device, layoutProbeSpirv, specializationFor(scene), buffers, sizeof constants);
  shader.dispatch(1, std::as_bytes(std::span(&constants, 1)));

  std::vector<std::uint32_t> words(expected.size());
  std::memcpy(words.data(), buffers[gpu::kBindingProbeOut].bytes(), 4 * words.size());
  EXPECT_EQ(words, expected);

  EXPECT_EQ(shared->results[1].sum, glm::vec3(1, 2, 3));
  EXPECT_EQ(shared->results[1].squares, 4.0F);
  EXPECT_EQ(shared->statuses[1].unfinished, 5U);
  EXPECT_EQ(shared->statuses[1].stuck, 6U);
  EXPECT_EQ(shared->statuses[1].shadowRays, 7U);
  EXPECT_EQ(shared->statuses[1].mirrorRays, 8U);
  EXPECT_EQ(shared->statuses[1].skippedShadowRays, 9U);
  EXPECT_EQ(shared->statuses[1].turns[0], 13U);
  EXPECT_EQ(shared->statuses[1].higherOfTurns[3], 20U);
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
