#include <lavaray/renderer.h>

#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "library/scenes.hpp"

namespace lavaray {
namespace {

constexpr int kRounds = 3;

RenderOptions options(std::uint32_t seed) {
  RenderOptions options;
  options.samples = 8;
  options.seed = seed;
  return options;
}

std::vector<float> rendered(const Renderer& renderer, const Scene& scene, std::uint32_t seed) {
  return renderer.render(scene, options(seed)).image.rgb;
}

Scene meshScene() {
  Scene scene = objectScene();
  for (int i = 0; i < 20; ++i) scene.add(octahedron({0.3 * i - 3.0, 1.0 + 0.1 * i, -0.5 * i}));
  return scene;
}

// Several threads call work(i) for i = 0 and 1, each kRounds times.
template <typename Work>
void inTwoThreads(const Work& work) {
  const auto repeat = [&](std::uint32_t i) {
    for (int round = 0; round < kRounds; ++round) work(i);
  };
  std::thread first(repeat, 0);
  std::thread second(repeat, 1);
  first.join();
  second.join();
}

TEST(LibraryThreads, RenderersOfTheirOwn) {
  const Scene scenes[] = {objectScene(), meshScene()};
  std::vector<float> alone[2];
  for (std::uint32_t i = 0; i < 2; ++i) alone[i] = rendered(Renderer(), scenes[i], i);
  inTwoThreads([&](std::uint32_t i) { EXPECT_EQ(rendered(Renderer(), scenes[i], i), alone[i]); });
}

TEST(LibraryThreads, OneDeviceAndOneScene) {
  const Renderer renderer;
  std::vector<float> alone[2];
  for (std::uint32_t i = 0; i < 2; ++i) alone[i] = rendered(renderer, meshScene(), i);
  const Scene scene = meshScene();  // whose hierarchy is made by one of them
  inTwoThreads([&](std::uint32_t i) { EXPECT_EQ(rendered(renderer, scene, i), alone[i]); });
}

TEST(LibraryThreads, ScenesAreReadAndFilesWritten) {
  const std::string folder = testing::TempDir();
  inTwoThreads([&](std::uint32_t i) {
    const Scene scene = Scene::parse(kText);
    const Image image{2, 1, {0.0F, 0.2F, 0.4F, 0.6F, 0.8F, static_cast<float>(i)}, {}, {}};
    const std::string file = folder + "lavaray-threads-" + std::to_string(i) + ".pfm";
    writeImage(image, file);
    EXPECT_EQ(readImage(file).rgb, image.rgb);
    EXPECT_EQ(scene.summary().spheres, 1U);
  });
}

}  // namespace
}  // namespace lavaray
