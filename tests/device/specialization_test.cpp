// What a scene does not need is skipped: code in the pipeline, shadow rays, pixels. That must not change a
// bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <vector>

#include "device/render_scene.hpp"
#include "scene/scene_reader.hpp"
#include "support/image_compare.hpp"

namespace lavaray {
namespace {

std::vector<std::filesystem::path> allScenes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(LAVARAY_SCENES_DIR)) {
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void expectSameBits(const Scene& scene, RenderSettings settings, const std::string& what) {
  const Image specialized = renderScene(scene, settings).image;
  settings.specialized = false;
  EXPECT_EQ(specialized.rgb, renderScene(scene, settings).image.rgb) << what;
}

// Where a device's texels do not reach.
void expectSameBitsFromStorage(const Scene& scene, RenderSettings settings, const std::string& what) {
  const Image fromTexels = renderScene(scene, settings).image;
  settings.sceneInStorage = true;
  EXPECT_EQ(fromTexels.rgb, renderScene(scene, settings).image.rgb) << what << ", from storage buffers";
}

void expectSameBitsTogether(const Scene& scene, RenderSettings settings, const std::string& what) {
  std::vector<float> single;
  for (const std::uint32_t rays : {1U, 2U, 4U}) {
    settings.raysPerLane = rays;
    const RenderResult result = renderScene(scene, settings);
    if (rays == 1) single = result.image.rgb;
    const std::string which = what + ", " + std::to_string(rays) + " rays";
    EXPECT_EQ(single, result.image.rgb) << which;
    EXPECT_EQ(result.counts.givenUp, 0U) << which;
  }
}

// Odd sizes leave blocks of pixels incomplete at both ends. A target error has work items of two samples and
// of four, which share an invocation or do not.
TEST(Specialization, RaysTracedTogetherChangeNoBitOfAnyScene) {
  for (const std::filesystem::path& file : allScenes()) {
    const Scene scene = readScene(file);
    const std::string name = file.filename().string();
    RenderSettings settings;
    settings.size = reducedSize(scene.camera, 75);
    settings.crop = {1, 2, settings.size.width, settings.size.height - 1};
    for (const std::uint32_t samples : {1U, 2U, 7U}) {
      settings.samples = samples;
      expectSameBitsTogether(scene, settings, name + ", " + std::to_string(samples) + " samples");
    }
    settings.targetError = 0.01;
    expectSameBitsTogether(scene, settings, name + ", to a target error");
  }
}

TEST(Specialization, ChangesNoBitOfAnyScene) {
  const std::vector<std::filesystem::path> files = allScenes();
  ASSERT_GE(files.size(), 17U);
  for (const std::filesystem::path& file : files) {
    const Scene scene = readScene(file);
    RenderSettings settings;
    settings.size = reducedSize(scene.camera, 64);
    settings.crop = {0, 0, settings.size.width, settings.size.height};
    expectSameBits(scene, settings, file.filename().string() + ", pixels' centres");
    expectSameBitsFromStorage(scene, settings, file.filename().string());
    settings.samples = 2;
    settings.filter = PixelFilter::kGaussian;
    expectSameBits(scene, settings, file.filename().string() + ", 2 samples");
  }
  std::cout << files.size() << " scenes are the same, bit for bit\n";
}

// Triangles that coincide, in part or as a whole, and balls that touch them, from one to as many as are few,
// and one more.
TEST(Specialization, ChangesNoBitOfScenesOfFewPrimitives) {
  Scene scene;
  scene.camera = {{0, 0, 0}, 60.0, 60.0, 1.25};
  scene.lights = {{{3, 9, 4}, glm::dvec3(0.1), glm::dvec3(1.0), glm::dvec3(0.5)}};
  const ImageSize size = imageSize(scene.camera).value();
  RenderSettings settings;
  settings.size = size;
  settings.crop = {0, 0, size.width, size.height};
  for (std::uint32_t i = 0; i <= gpu::kMaxFewPrimitives; ++i) {
    const double shade = 0.1 + 0.09 * i;
    scene.materials.push_back({{shade, 0.3, 1.0 - shade}, glm::dvec3(0.4), glm::dvec3(0.3), 9.0});
    if (i % 2 == 0) {
      scene.triangles.push_back({{{{-2, -1.0 - i % 4, -6}, {2, -1, -6}, {0, 2, -6}}}, i});
    } else {
      scene.spheres.push_back({{0.5 * i - 2.0, 0.25 * (i % 3), -6.0 - i % 5}, 1.0 + i % 2, i});
    }
    expectSameBits(scene, settings, std::to_string(i + 1) + " primitives");
  }
}

// A ball in a corner of the image: what lies outside its rectangle is never dispatched, and black.
TEST(Specialization, SkipsPixelsThatNothingCanShowIn) {
  Scene scene;
  scene.camera = {{3, 4, 5}, 60.0, 100.0, 1.5};
  scene.materials = {{glm::dvec3(0.5), glm::dvec3(0.0), glm::dvec3(0.0), 1.0}};
  scene.spheres = {{scene.camera.position + glm::dvec3(4, 2, -10), 1.0, 0}};
  const ImageSize size = imageSize(scene.camera).value();
  RenderSettings settings;
  settings.size = size;
  settings.crop = {0, 0, size.width, size.height};
  const RenderResult result = renderScene(scene, settings);
  const auto pixels = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
  EXPECT_EQ(result.skippedPixels + result.counts.samples, pixels);
  EXPECT_GT(result.skippedPixels, pixels * 9 / 10);
  expectSameBits(scene, settings, "whole");
  // The ball in part, and none of it.
  settings.crop = {size.width / 2, 0, size.width - 30, 40};
  expectSameBits(scene, settings, "part");
  settings.crop = {0, 60, 50, 80};
  EXPECT_EQ(renderScene(scene, settings).counts.dispatches, 0U);
  expectSameBits(scene, settings, "background");
}

// Balls in two corners: between them is nothing, and samples there are not traced.
TEST(Specialization, SkipsCameraRaysThroughTilesWithNothing) {
  Scene scene;
  scene.camera = {{0, 0, 0}, 60.0, 150.0, 1.0};
  for (std::uint32_t i = 0; i < 12; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    scene.materials.push_back({glm::dvec3(0.3 + 0.05 * i), glm::dvec3(0.2), glm::dvec3(0.0), 1.0});
    scene.spheres.push_back({{side * (3.0 + 0.1 * i), side * (4.0 - 0.2 * i), -9.0 - 0.3 * i}, 0.4, i});
  }
  const ImageSize size = imageSize(scene.camera).value();
  RenderSettings settings;
  settings.size = size;
  settings.crop = {0, 0, size.width, size.height};
  settings.samples = 3;
  settings.filter = PixelFilter::kBlackmanHarris;
  const RenderResult result = renderScene(scene, settings);
  const std::uint64_t sampledPixels = std::uint64_t{1} * size.width * size.height - result.skippedPixels;
  EXPECT_EQ(result.counts.samples, 3 * sampledPixels);
  EXPECT_EQ(result.samplesPerPixel, 3.0);
  EXPECT_GT(result.counts.skippedSamples, 3 * sampledPixels);
  // The cost is another one without what is skipped.
  for (const View view : {View::kColor, View::kNormal, View::kDepth, View::kObject, View::kShadow}) {
    settings.view = view;
    expectSameBits(scene, settings, "view " + std::to_string(static_cast<int>(view)));
  }
  settings.view = View::kColor;
  settings.targetError = 0.02;
  expectSameBits(scene, settings, "target error");
}

// Nothing reaches the eye from a light behind the surface, nor from one more light on what is white already.
TEST(Specialization, SkipsShadowRaysThatCannotChangeAPixel) {
  Scene scene;
  scene.camera = {{0, 0, 0}, 60.0, 100.0, 1.0};
  scene.materials = {{glm::dvec3(0.1), glm::dvec3(1.0), glm::dvec3(0.0), 1.0}};
  scene.planes = {{{0, 0, 1}, {0, 0, -5}, 0}};
  scene.lights = {{{0, 0, -9}, glm::dvec3(0.0), glm::dvec3(1.0), glm::dvec3(0.0)},
                  {{0, 0, 100}, glm::dvec3(0.0), glm::dvec3(2.0), glm::dvec3(0.0)},
                  {{0, 0, 50}, glm::dvec3(0.0), glm::dvec3(2.0), glm::dvec3(0.0)}};
  const ImageSize size = imageSize(scene.camera).value();
  RenderSettings settings;
  settings.size = size;
  settings.crop = {0, 0, size.width, size.height};
  settings.countRays = true;
  const TraceCounts counts = renderScene(scene, settings).counts;
  EXPECT_EQ(counts.shadowRays, counts.samples);
  EXPECT_EQ(counts.skippedShadowRays, 2 * counts.samples);
}

}  // namespace
}  // namespace lavaray
