#include "render/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bvh/flatten.hpp"
#include "render/render.hpp"
#include "render/variant.hpp"

namespace lavaray {
namespace {

constexpr int kSlices = 128;
constexpr int kStacks = 64;
// Sides of the picture. Traced by a GPU, the smaller one takes less time than its dispatch.
constexpr int kSideOnCpu = 256;
constexpr int kSideOnGpu = 2048;
constexpr int kRounds = 3;
// Rays of a render for which it is worth measuring: some 10 seconds on two cores; not yet tried on a GPU.
constexpr double kRaysWorthMeasuringOnCpu = 1e8;
constexpr double kRaysWorthMeasuringOnGpu = 1e10;
// What is less than so much faster may be noise.
constexpr double kClearly = 0.95;

// A point of a unit sphere with bumps, so that triangles are of all sizes and hide one another.
glm::dvec3 pointOfBall(int slice, int stack) {
  const double phi = 2.0 * std::numbers::pi * slice / kSlices;
  const double theta = std::numbers::pi * stack / kStacks;
  const double radius = 1.0 + 0.1 * std::sin(9.0 * phi) * std::sin(theta) * std::cos(11.0 * theta);
  return radius *
         glm::dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
}

Mesh bumpyBall() {
  Mesh mesh;
  for (int stack = 0; stack <= kStacks; ++stack) {
    for (int slice = 0; slice < kSlices; ++slice) mesh.positions.push_back(pointOfBall(slice, stack));
  }
  const auto index = [](int slice, int stack) {
    return static_cast<std::uint32_t>(stack * kSlices + slice % kSlices);
  };
  for (int stack = 0; stack < kStacks; ++stack) {
    for (int slice = 0; slice < kSlices; ++slice) {
      const std::uint32_t a = index(slice, stack);
      const std::uint32_t b = index(slice + 1, stack);
      const std::uint32_t c = index(slice + 1, stack + 1);
      const std::uint32_t d = index(slice, stack + 1);
      if (stack > 0) mesh.triangles.push_back({.positions = {a, b, c}});
      if (stack < kStacks - 1) mesh.triangles.push_back({.positions = {a, c, d}});
    }
  }
  return mesh;
}

// The ball fills the picture, and hides half of itself from a light beside the camera.
GpuScene testScene() {
  Scene scene;
  scene.camera.position = {0.0, 0.0, 2.5};
  scene.meshes.push_back(bumpyBall());
  scene.meshObjects.push_back({.mesh = 0, .object = 0});
  Material white;
  white.diffuse = glm::dvec3(1.0);
  scene.materials.push_back(white);
  Light light;
  light.position = {3.0, 2.0, 2.0};
  light.diffuse = glm::dvec3(1.0);
  scene.lights.push_back(light);
  return flatten(scene, 1);
}

double secondsOf(vulkan::Device& device, const GpuScene& scene, const Tuning& tuning) {
  const int side = device.description().isCpu ? kSideOnCpu : kSideOnGpu;
  RenderSettings settings;
  settings.size = {side, side};
  settings.crop = {0, 0, side, side};
  settings.recordTimes = true;
  settings.tuning = tuning;
  settings.raysPerLane = tuning.raysPerLane;
  const vulkan::Activity activity = render(device, scene, settings).activity;
  return activity.seconds - activity.deviceIdleSeconds;
}

// In turns, so that other work on the machine delays each of them alike.
void measure(vulkan::Device& device, const GpuScene& scene, std::span<TuningTime> times) {
  for (const TuningTime& time : times) secondsOf(device, scene, time.tuning);  // compiles
  for (int round = 0; round < kRounds; ++round) {
    for (TuningTime& time : times)
      time.seconds = std::min(time.seconds, secondsOf(device, scene, time.tuning));
  }
}

}  // namespace

Tuning usualTuning(bool isCpu) {
  return {.sceneInStorage = false, .raysPerLane = isCpu ? 4U : 1U};
}

bool isWorthMeasuring(bool isCpu, std::uint32_t lights, const RenderSettings& settings) {
  const double enough = isCpu ? kRaysWorthMeasuringOnCpu : kRaysWorthMeasuringOnGpu;
  return settings.shader.empty() && estimatedRays(lights, settings) >= enough;
}

std::vector<TuningTime> measureTunings(vulkan::Device& device) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const GpuScene scene = testScene();
  const Tuning usual = usualTuning(device.description().isCpu);
  const Tuning other{.sceneInStorage = !usual.sceneInStorage, .raysPerLane = usual.raysPerLane};
  std::vector<TuningTime> times{{usual, kNever}, {other, kNever}};
  measure(device, scene, times);
  // Where the scene lies and how many rays are traced together are nearly independent of each other, and each
  // way is another module to compile.
  const bool inStorage = fastest(times).sceneInStorage;
  const std::size_t known = times.size();
  for (const std::uint32_t rays : {1U, 2U, 4U}) {
    if (rays != usual.raysPerLane) times.push_back({{inStorage, rays}, kNever});
  }
  measure(device, scene, std::span(times).subspan(known));
  return times;
}

Tuning fastest(std::span<const TuningTime> times) {
  const auto best = std::ranges::min_element(times, {}, &TuningTime::seconds);
  return best->seconds < kClearly * times.front().seconds ? best->tuning : times.front().tuning;
}

}  // namespace lavaray
