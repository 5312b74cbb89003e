// Whole images from the device: against the double-precision oracle, and against themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "device/render_scene.hpp"
#include "oracle/oracle.hpp"
#include "support/image_compare.hpp"
#include "support/scene_files.hpp"

namespace lavaray {
namespace {

// One sample of a spherical light is a guess; with points for lights the pixel's centre has an exact answer.
Scene withPointLights(Scene scene) {
  for (Light& light : scene.lights) light.radius = 0.0;
  return scene;
}

void expectEqualsOracle(const Scene& original, const ImageSize& size) {
  const Scene scene = withPointLights(original);
  oracle::Options options;
  options.size = size;
  const Comparison comparison = compare(renderScene(scene, size).image.rgb, oracle::render(scene, options));
  EXPECT_EQ(comparison.wrong, 0) << describe(comparison);
  EXPECT_LT(comparison.uncertainShare(), 0.5) << describe(comparison);
  std::cout << describe(comparison) << '\n';
}

class SceneImage : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(, SceneImage, testing::ValuesIn(sceneNames()),
                         [](const auto& test) { return asIdentifier(test.param); });

TEST_P(SceneImage, IsTheSameTwiceAndInParts) {
  const Scene scene = readNamed(GetParam());
  const ImageSize size = reducedSize(scene.camera, 300);
  const Image whole = renderScene(scene, size).image;
  EXPECT_TRUE(sameBits(whole.rgb, renderScene(scene, size).image.rgb)) << "rendered twice";
  const int x = size.width / 3;
  const int y = size.height / 2;
  for (const Rectangle& part : {Rectangle{0, 0, x, y}, Rectangle{x, y, size.width, size.height},
                                Rectangle{x, 0, x + 1, size.height}, Rectangle{0, y, size.width, y + 1}}) {
    EXPECT_TRUE(sameBits(crop(whole, part).rgb, renderScene(scene, size, part).image.rgb))
        << "crop " << part.x0 << ',' << part.y0 << ',' << part.x1 << ',' << part.y1;
  }
}

Scene sphereOnPlane(int lightCount) {
  Scene scene;
  scene.camera = {{0, 1, 6}, 45.0, 120.0, 1.2};
  scene.materials = {{{0.1, 0.1, 0.1}, {0.6, 0.5, 0.4}, {0.3, 0.3, 0.3}, 10.0, {}},
                     {{0.1, 0.1, 0.2}, {0.5, 0.5, 0.6}, {0.0, 0.0, 0.0}, 1.0, {}}};
  scene.spheres = {{{0, 1, 0}, 1.0, 0}};
  scene.planes = {{{0, 1, 0}, {0, 0, 0}, 1}};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-5.0, 5.0);
  for (int i = 0; i < lightCount; ++i) {
    const glm::dvec3 color(0.9 / lightCount);
    scene.lights.push_back(
        {{coordinate(random), 6.0 + coordinate(random), coordinate(random)}, color * 0.1, color, color, 0.0});
  }
  return scene;
}

// More lights than a dispatch handles, so that every pixel takes several.
TEST(Image, EqualsTheOracleWithManyLights) {
  const Scene scene = sphereOnPlane(600);
  const ImageSize size = reducedSize(scene.camera, 60);
  expectEqualsOracle(scene, size);
  EXPECT_GE(renderScene(scene, size).counts.dispatches, 600U / gpu::kMaxShadowRaysPerDispatch + 1);
}

// So many shadow rays through a tree that an invocation's loops are used up before its lights are.
TEST(Image, IsRightWhereTheDeviceEndsTheLoops) {
  Scene scene = sphereOnPlane(20);
  // Layers between the lights and the plane: every shadow ray enters each layer's box and misses its
  // triangle.
  for (int i = 0; i < 3000; ++i) {
    const double y = 0.9 + 0.00003 * i;
    const auto object = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back(scene.materials[1]);
    scene.triangles.push_back({{{{-100, y, -20}, {20, y, 100}, {19.9, y, 100}}}, object});
  }
  const ImageSize size{24, 20};
  expectEqualsOracle(scene, size);
}

TEST(Image, ShowsBackgroundForAnEmptyScene) {
  Scene scene;
  scene.camera = {{0, 0, 0}, 60.0, 20.0, 1.0};
  const Image image = renderScene(scene).image;
  EXPECT_TRUE(std::all_of(image.rgb.begin(), image.rgb.end(), [](float value) { return value == 0.0F; }));
}

TEST(Image, ShowsAmbientColourOnlyWithoutLights) {
  Scene scene = sphereOnPlane(0);
  const ImageSize size = reducedSize(scene.camera, 40);
  const Image image = renderScene(scene, size).image;
  const std::size_t center = 3 * (static_cast<std::size_t>(size.width) * (size.height / 2) + size.width / 2);
  EXPECT_EQ(image.rgb[center], 0.1F);
}

TEST(Image, HandlesLightsInSurfacesAndCamerasInEverything) {
  Scene scene = sphereOnPlane(0);
  const glm::dvec3 white(0.3);
  scene.lights.push_back({{0, 0, 3}, white, white, white, 0.0});  // in the plane
  scene.lights.push_back({{0, 2, 0}, white, white, white, 0.0});  // on the sphere
  scene.lights.push_back({{0, 1, 0}, white, white, white, 0.0});  // in its centre
  scene.lights.push_back({{0, 1, 6}, white, white, white, 0.0});  // in the camera
  for (const glm::dvec3& position :
       {glm::dvec3(0, 1, 6), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 4), glm::dvec3(0, 1, 1)}) {
    scene.camera.position = position;
    const Image image = renderScene(scene, reducedSize(scene.camera, 60)).image;
    EXPECT_TRUE(std::all_of(image.rgb.begin(), image.rgb.end(),
                            [](float value) { return value >= 0.0F && value <= 1.0F; }));
    expectEqualsOracle(scene, reducedSize(scene.camera, 60));
  }
}

TEST(Image, Of8192By8192IsTheSameAsItsParts) {
  const Scene scene = sphereOnPlane(1);
  const ImageSize size{8192, 8192};
  const Image whole = renderScene(scene, size).image;
  const Rectangle part{4000, 8100, 4200, 8192};
  EXPECT_TRUE(sameBits(crop(whole, part).rgb, renderScene(scene, size, part).image.rgb));
  EXPECT_GT(whole.rgb.back(), 0.0F);
}

}  // namespace
}  // namespace lavaray
