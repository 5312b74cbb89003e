// So many lights that their loops use up what the device allows, though no shadow ray is traced for them.
#include <gtest/gtest.h>

#include <iostream>

#include "device/render_scene.hpp"
#include "device/sampled_image.hpp"

namespace lavaray {
namespace {

// See kMaxTraversalSteps: where llvmpipe ends loops.
constexpr std::size_t kMaxTurns = 65535;

// The camera in the origin sees a wall that fills the image; the lights are behind it.
Scene wallBeforeLights(const Material& material, std::size_t lights, double lightRadius) {
  Scene scene;
  scene.camera = {{0, 0, 0}, 60.0, 10.0, 1.0};
  scene.planes = {{{0, 0, 1}, {0, 0, -4}, addObject(scene, material)}};
  for (std::size_t i = 0; i < lights; ++i) {
    const auto x = static_cast<double>(i % 100);
    const auto y = static_cast<double>(i / 100);
    scene.lights.push_back({.position = {x - 50.0, 0.1 * y, -60.0},
                            .diffuse = glm::dvec3(1.0),
                            .specular = glm::dvec3(1.0),
                            .radius = lightRadius});
  }
  return scene;
}

Material matte(const glm::dvec3& ambient) {
  return {.ambient = ambient, .diffuse = glm::dvec3(0.9), .specular = glm::dvec3(0.5), .shininess = 4.0};
}

void expectAmbientColor(const Scene& scene, std::uint32_t samples) {
  const ImageSize size{9, 9};
  const RenderResult result = renderScene(scene, settingsFor(size, samples));
  const glm::vec3 ambient = scene.materials[0].ambient;
  for (std::size_t i = 0; i < result.image.rgb.size(); ++i) {
    EXPECT_EQ(result.image.rgb[i], ambient[static_cast<int>(i % 3)]) << "value " << i;
  }
  EXPECT_EQ(result.counts.shadowRays, 0U);
  std::cout << scene.lights.size() << " lights, " << samples
            << " samples: " << result.counts.skippedShadowRays << " shadow rays skipped in "
            << result.counts.dispatches << " dispatches\n";
}

TEST(ManyLights, ThatShineFromBehindAddNothing) {
  const Scene scene = wallBeforeLights(matte({0.25, 0.5, 0.75}), 20'000, 0.0);
  for (const std::uint32_t samples : {1U, 2U, 9U}) expectAmbientColor(scene, samples);
}

TEST(ManyLights, MayBeMoreThanTheLoopHasTurns) {
  const Scene scene = wallBeforeLights(matte({0.25, 0.5, 0.75}), 2 * kMaxTurns, 0.0);
  for (const std::uint32_t samples : {1U, 2U}) expectAmbientColor(scene, samples);
}

TEST(ManyLights, MayBeSpherical) {
  // Close to white, so that each sample looks at the lights in several directions.
  const Scene scene = wallBeforeLights(matte({0.96875, 0.5, 0.25}), 20'000, 1.0);
  for (const std::uint32_t samples : {1U, 4U}) expectAmbientColor(scene, samples);
}

// Between two mirrors a path looks at all lights again and again, to find in how many directions each of them
// is to be looked at. A wrong number would show in the rays to those that shine: the last one, whose light
// makes it many directions, and the first one, which is the one that is looked at next.
TEST(ManyLights, AreLookedAtInAllDirectionsAtEachBounce) {
  constexpr std::uint32_t kBounces = 5;
  const Material mirror{.ambient = {0.25, 0.0, 0.0}, .reflectance = glm::dvec3(0.25)};
  for (const std::size_t lights : {2U, 12'000U, 25'000U}) {
    Scene scene = wallBeforeLights(mirror, lights, 1.0);
    // The mirrors fill the left half of the image: beside them a camera ray tests their four triangles in
    // vain. Another ray does not test the one that it leaves.
    scene.planes.clear();
    addParallelogram(scene, mirror, {-50, -50, -4}, {0, -50, -4}, {0, 50, -4});
    addParallelogram(scene, mirror, {-50, -50, 4}, {0, -50, 4}, {0, 50, 4});
    scene.lights.front().ambient = glm::dvec3(1e-3);
    scene.lights.back().ambient = glm::dvec3(1e6);
    RenderSettings settings = settingsFor({8, 1}, 1);
    settings.view = View::kCost;
    settings.maxDepth = kBounces;
    const RenderResult result = renderScene(scene, settings);
    const std::uint32_t shadowRays = (1 + kBounces) * 2 * gpu::kClampedLightDirections;
    const std::uint32_t tests = 4 + 3 * (kBounces + shadowRays);
    EXPECT_EQ(result.largestMeasure, tests);
    for (std::size_t x = 0; x < 8; ++x) {
      EXPECT_EQ(result.image.rgb[3 * x], x < 4 ? 1.0F : 4.0F / static_cast<float>(tests)) << "pixel " << x;
    }
    std::cout << lights << " lights: " << result.largestMeasure << " tests in " << result.counts.dispatches
              << " dispatches\n";
  }
}

}  // namespace
}  // namespace lavaray
