// The same bits of a sampled image, however it is divided into parts and dispatches. (That the number of
// threads does not matter either is tested with the program, as a driver asks for it once.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <random>
#include <vector>

#include "bvh/flatten.hpp"
#include "device/render_scene.hpp"
#include "device/sampled_image.hpp"
#include "device/test_device.hpp"
#include "render/small_objects.hpp"
#include "render/tracer.hpp"
#include "sampling/adaptive_plan.hpp"
#include "sampling/pixel_sum.hpp"
#include "sampling/sample_sums.hpp"

namespace lavaray {
namespace {

TEST(Determinism, SampledImagesAreTheSameTwiceAndInParts) {
  const Scene scene = readNamed("extensions");
  const ImageSize size = reducedSize(scene.camera, 120);
  for (const std::uint32_t samples : {2U, 5U, 70U}) {
    RenderSettings settings = settingsFor(size, samples);
    settings.filter = PixelFilter::kGaussian;
    const Image whole = renderScene(scene, settings).image;
    EXPECT_TRUE(sameBits(whole, renderScene(scene, settings).image)) << samples;
    for (const Rectangle& part : {Rectangle{31, 17, 64, 50}, Rectangle{0, 0, 1, 1}, Rectangle{0, 60, 120, 61},
                                  Rectangle{119, 0, 120, size.height}}) {
      settings.crop = part;
      EXPECT_TRUE(sameBits(crop(whole, part), renderScene(scene, settings).image)) << samples;
    }
    std::cout << samples << " samples: " << whole.rgb.size() << " values compared with those of parts\n";
  }
}

// The renderer's batches grow and shrink with the time that they take, so no image may depend on them.
TEST(Determinism, BatchesOfAnySizeInAnyOrderMakeTheSameImage) {
  const Scene scene = readNamed("extensions");
  constexpr std::uint32_t kSamples = 70;
  RenderSettings settings = settingsFor(reducedSize(scene.camera, 120), kSamples);
  settings.crop = {20, 30, 60, 50};
  const Image image = renderScene(scene, settings).image;
  WorkList items;
  for (std::uint32_t pixel = 0; pixel < image.rgb.size() / 3; ++pixel) {
    for (std::uint32_t first = 0; first < kSamples; first += gpu::kMaxSamplesPerItem) {
      items.push_back({pixel, 0, first, std::min(gpu::kMaxSamplesPerItem, kSamples - first)});
    }
  }
  const GpuScene gpuScene = flatten(scene, 1);
  std::mt19937 random(1);
  for (const std::uint64_t largestBatch : {97U, 1000U, 1U << 20U}) {
    std::shuffle(items.begin(), items.end(), random);
    std::vector<PixelSum> sums(image.rgb.size() / 3);
    Tracer tracer(testDevice(), gpuScene, settings, settings.crop, largestBatch);
    tracer.run(
        listedPass(items), 0,
        [&](std::uint64_t first, std::span<const gpu::WorkResult> results) {
          for (const gpu::WorkResult& result : results) {
            const gpu::WorkItem& item = items[first++];
            sums[item.pixel].add(result.sum, item.count);
          }
        },
        [] { return false; });
    std::size_t differing = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
      const glm::vec3 mean(sums[i / 3].mean());
      differing += image.rgb[i] != mean[static_cast<int>(i % 3)] ? 1 : 0;
    }
    EXPECT_EQ(differing, 0U);
    std::cout << differing << " of " << image.rgb.size() << " values differ after "
              << tracer.counts().dispatches << " dispatches\n";
  }
}

// The general pipeline, which can leave items half done, and the one without that. No path here is so long
// that the number of bounces would show.
TEST(Determinism, ResumablePipelinesMakeTheSameImage) {
  Scene scene = readNamed("extensions");
  scene.lights.resize(1);
  for (Material& material : scene.materials) material.reflectance *= 0.05;
  RenderSettings settings = settingsFor(reducedSize(scene.camera, 80), 16);
  settings.maxDepth = 3;
  const RenderResult direct = renderScene(scene, settings);
  settings.maxDepth = 200;
  const RenderResult resumable = renderScene(scene, settings);
  EXPECT_GT(resumable.deviceBytes, direct.deviceBytes);  // it has a buffer more
  EXPECT_GT(direct.counts.mirrorRays, 0U);
  EXPECT_TRUE(sameBits(direct.image, resumable.image));
  std::cout << direct.counts.mirrorRays << " mirror rays, " << direct.counts.dispatches << " and "
            << resumable.counts.dispatches << " dispatches\n";
}

RenderSettings adaptiveSettings(const Scene& scene) {
  RenderSettings settings = settingsFor(reducedSize(scene.camera, 90), 1);
  settings.targetError = 0.004;
  return settings;
}

// What the renderer does for a target error, but with batches and an order of its own.
Image renderToTarget(const Scene& scene, const RenderSettings& settings, std::uint64_t largestBatch) {
  const GpuScene gpuScene = flatten(scene, 1);
  const auto [width, height] = settings.size;
  const std::uint64_t pixels = settings.crop.pixels();
  AdaptivePlan plan(settings.size, {*settings.targetError, settings.maxSamples, true},
                    pixelsOfSmallObjects(gpuScene, settings));
  SampleSums sums(SumKind::kHalves, pixels);
  Tracer tracer(testDevice(), gpuScene, settings, settings.crop, largestBatch);
  std::mt19937 random(5);
  for (SamplePass pass = plan.nextPass(sums.halves()); pass.items > 0; pass = plan.nextPass(sums.halves())) {
    std::shuffle(pass.list.begin(), pass.list.end(), random);
    tracer.run(
        pass, 0,
        [&](std::uint64_t first, std::span<const gpu::WorkResult> results) {
          sums.add(pass, first, results);
        },
        [] { return false; });
  }
  std::vector<glm::vec3> means(pixels);
  sums.copyMeans(0, means);
  Image image{width, height, {}};
  for (const glm::vec3& mean : means) image.rgb.insert(image.rgb.end(), {mean.r, mean.g, mean.b});
  return image;
}

TEST(Determinism, AdaptiveImagesAreTheSameTwiceAndFromBatchesOfAnySize) {
  const Scene scene = readNamed("extensions");
  RenderSettings settings = adaptiveSettings(scene);
  const Image image = renderScene(scene, settings).image;
  EXPECT_TRUE(sameBits(image, renderScene(scene, settings).image));
  EXPECT_TRUE(sameBits(image, renderToTarget(scene, settings, 331)));
  EXPECT_TRUE(sameBits(image, renderToTarget(scene, settings, 1U << 20U)));
  settings.timeLimitSeconds = 3600.0;
  EXPECT_TRUE(sameBits(image, renderScene(scene, settings).image));
  std::cout << image.rgb.size() << " values compared\n";
}

struct AdaptiveImage {
  Image image;
  std::vector<std::uint32_t> samples;  // of each pixel
};

AdaptiveImage renderWithSamples(const Scene& scene, RenderSettings settings) {
  AdaptiveImage result{renderScene(scene, settings).image, {}};
  settings.view = View::kSamples;
  const RenderResult counts = renderScene(scene, settings);
  for (std::size_t i = 0; i < counts.image.rgb.size(); i += 3) {
    result.samples.push_back(
        static_cast<std::uint32_t>(std::lround(double{counts.image.rgb[i]} * counts.maxSamples)));
  }
  return result;
}

// How many samples a pixel gets depends on its neighbours and on the error of the whole image, so a part by
// itself is sampled otherwise. But with as many samples a pixel shows the same, whatever the passes in which
// they were taken.
TEST(Determinism, AdaptivePixelsDependOnTheNumberOfTheirSamplesOnly) {
  const Scene scene = readNamed("extensions");
  RenderSettings settings = adaptiveSettings(scene);
  const AdaptiveImage whole = renderWithSamples(scene, settings);
  settings.crop = {10, 15, 70, 45};
  const AdaptiveImage part = renderWithSamples(scene, settings);
  const int width = settings.crop.width();
  std::size_t differing = 0;
  std::size_t alike = 0;
  for (std::size_t i = 0; i < part.samples.size(); ++i) {
    const std::size_t inWhole =
        (i / width + settings.crop.y0) * settings.size.width + i % width + settings.crop.x0;
    if (part.samples[i] != whole.samples[inWhole]) continue;
    ++alike;
    for (int channel = 0; channel < 3; ++channel) {
      differing += part.image.rgb[3 * i + channel] != whole.image.rgb[3 * inWhole + channel] ? 1 : 0;
    }
  }
  EXPECT_EQ(differing, 0U);
  EXPECT_GT(alike, part.samples.size() / 10);
  std::cout << alike << " of " << part.samples.size() << " pixels have as many samples; " << differing
            << " of their values differ\n";
}

}  // namespace
}  // namespace lavaray
