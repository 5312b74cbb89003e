// Scenes that try to break the reader or the renderer: each is refused with a message, or rendered in the
// time of a scene that is fine, into a picture of numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>

#include "base/errors.hpp"
#include "bvh/flatten.hpp"
#include "device/probe.hpp"
#include "device/render_scene.hpp"
#include "pathProbeSpirv.spv.h"
#include "scene/camera.hpp"
#include "scene/scene_reader.hpp"
#include "stress/hostile_scene.hpp"
#include "stress/report.hpp"
#include "stress/shaders/stress_probes.h"
#include "support/input_files.hpp"

namespace lavaray {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Nothing where the reader refuses the scene, which it may only do with a message about a line.
std::optional<Scene> readText(const SceneText& text) {
  if (!text.mesh.empty()) writeFile("mesh.obj", text.mesh);
  const auto file = writeFile("scene.txt", text.scene);
  try {
    return readScene(file);
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.exitCode(), ExitCode::kInput) << message;
    EXPECT_NE(message.find(testFolder().string()), std::string::npos) << message;
    return std::nullopt;
  }
}

struct Rendered {
  double seconds = 0.0;
  bool isFine = true;  // all values are within [0, 1]
};

Rendered renderSmall(const Scene& scene) {
  const Clock::time_point start = Clock::now();
  const Image image = renderScene(scene, reducedSize(scene.camera, 32)).image;
  const double seconds = secondsSince(start);
  const bool isFine =
      std::all_of(image.rgb.begin(), image.rgb.end(), [](float v) { return v >= 0.0F && v <= 1.0F; });
  return {seconds, isFine};
}

// Pixels whose colour before the clamping is no number. An infinite one is white.
std::size_t countNaN(const Scene& scene) {
  const GpuScene gpuScene = flatten(scene, 1);
  const gpu::PathConstants constants{32, 24, 30.0F, gpuScene.hasMirrors ? 8U : 0U};
  const std::vector<gpu::uint> pixels(constants.width * constants.height);
  std::size_t count = 0;
  for (const gpu::PathColor& pixel : runProbe<gpu::PathColor>(pathProbeSpirv, gpuScene, pixels, constants)) {
    const bool isNaN = std::isnan(pixel.color.r) || std::isnan(pixel.color.g) || std::isnan(pixel.color.b);
    if (isNaN) ++count;
    EXPECT_EQ(pixel.finished, 1U);
  }
  return count;
}

// Between two mirrors that are brighter than any, a path's weight grows beyond all floats.
TEST(HostileScenes, MirrorsOfHugeReflectanceShowNumbers) {
  Scene scene;
  scene.camera = {{0, 0, 0}, 60.0, 20.0, 1.33};
  addPlane(scene, {0.1, 0, 1}, {0, 0, -5});
  addPlane(scene, {0, 0.1, 1}, {0, 0, 5});
  for (Material& material : scene.materials) {
    material = {{0.0, 0.1, 0.2}, {0.0, 0.0, 0.5}, {0.0, 0.5, 0.0}, 5.0, {1e15, 1e15, 1e-40}};
  }
  scene.lights.push_back({{0, 3, 0}, glm::dvec3(0.0), glm::dvec3(1.0), glm::dvec3(1.0)});
  const std::size_t pixels = countNaN(scene);
  EXPECT_EQ(pixels, 0U);
  report(grouped(pixels) + " pixels that are no number");
}

// Of each kind, so that a hostile scene is compared with its like.
std::array<double, kSceneKinds> secondsOfCleanScenes() {
  constexpr int kRepeats = 5;
  std::array<double, kSceneKinds> seconds{};
  for (int kind = 0; kind < kSceneKinds; ++kind) {
    Random random(static_cast<unsigned>(kind));
    for (int i = 0; i <= kRepeats; ++i) {
      const std::optional<Scene> scene = readText(makeSceneText(kind, false, random));
      EXPECT_TRUE(scene) << "a scene that should be fine";
      const double once = scene ? renderSmall(*scene).seconds : 0.0;
      if (i > 0) seconds[kind] += once / kRepeats;  // the first time the driver may compile
    }
  }
  return seconds;
}

TEST(HostileScenes, AreRefusedOrRendered) {
  const std::array<double, kSceneKinds> cleanSeconds = secondsOfCleanScenes();
  const std::size_t count = sized(300, 10'000);
  std::size_t refused = 0;
  std::size_t notANumber = 0;
  double hostileTotal = 0.0;
  double cleanTotal = 0.0;
  double longest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto kind = static_cast<int>(i % kSceneKinds);
    Random random(static_cast<unsigned>(i));
    const SceneText text = makeSceneText(kind, true, random);
    const std::optional<Scene> scene = readText(text);
    if (!scene) {
      ++refused;
      continue;
    }
    const Rendered rendered = renderSmall(*scene);
    EXPECT_TRUE(rendered.isFine) << "seed " << i << '\n' << text.scene << text.mesh;
    const std::size_t pixels = countNaN(*scene);
    EXPECT_EQ(pixels, 0U) << "seed " << i << '\n' << text.scene << text.mesh;
    notANumber += pixels;
    hostileTotal += rendered.seconds;
    cleanTotal += cleanSeconds[kind];
    longest = std::max(longest, rendered.seconds);
  }
  EXPECT_LT(refused, 3 * count / 4);
  EXPECT_GT(refused, count / 10);
  EXPECT_LE(hostileTotal, 2.5 * cleanTotal);
  report(grouped(notANumber) + " pixels that are no number in " + grouped(count) + " scenes, " +
         grouped(refused) + " of them refused; the others took " + shortNumber(hostileTotal / cleanTotal) +
         " times as long as clean scenes, none more than " + shortNumber(longest) + " s");
}

}  // namespace
}  // namespace lavaray
