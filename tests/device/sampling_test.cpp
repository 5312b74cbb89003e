// Sampled images from the device: agreement with the oracle, and with the error that is asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "device/render_scene.hpp"
#include "device/sampled_image.hpp"
#include "oracle/oracle.hpp"

namespace lavaray {
namespace {

TEST(Sampling, SeedsGiveOtherSamplesOfTheSamePicture) {
  const Scene scene = readNamed("extensions");
  RenderSettings settings = settingsFor(reducedSize(scene.camera, 80), 256);
  const Image first = renderScene(scene, settings).image;
  settings.seed = 1;
  const Image second = renderScene(scene, settings).image;
  EXPECT_FALSE(sameBits(first, second));
  const std::vector<double> truth(first.rgb.begin(), first.rgb.end());
  EXPECT_LT(rmse(second, truth), 0.003);
}

// The share of pixels whose mean differs from the oracle's by no more than chance allows, at a significance
// of 0.01 after Sidak's correction for the number of tests, as Mitsuba tests its renders. Both images have as
// many independent samples' worth of error at most.
double acceptedShare(const Image& image, const oracle::Result& truth, double smallestDeviation) {
  const double tests = 3.0 * static_cast<double>(truth.pixels.size());
  const double significance = 1.0 - std::pow(1.0 - 0.01, 1.0 / tests);
  std::size_t accepted = 0;
  for (std::size_t pixel = 0; pixel < truth.pixels.size(); ++pixel) {
    bool all = true;
    for (int channel = 0; channel < 3; ++channel) {
      const double sigma =
          std::hypot(truth.pixels[pixel].standardError[channel] * std::sqrt(2.0), smallestDeviation);
      const double off =
          std::abs(double{image.rgb[3 * pixel + channel]} - truth.pixels[pixel].color[channel]);
      all = all && std::erfc(off / sigma / std::sqrt(2.0)) >= significance;
    }
    accepted += all ? 1 : 0;
  }
  return static_cast<double>(accepted) / static_cast<double>(truth.pixels.size());
}

TEST(Sampling, AgreesWithTheOracleByZTest) {
  for (const char* name : {"extensions", "spheres", "light-behind", "horizon"}) {
    const Scene scene = readNamed(name);
    const ImageSize size = reducedSize(scene.camera, 80);
    constexpr int kSamples = 512;
    oracle::Options options;
    options.size = size;
    options.samples = kSamples;
    const oracle::Result truth = oracle::render(scene, options);
    // What an edge that takes less of the pixel than one of the oracle's samples can hide.
    constexpr double kHidden = 0.5 / kSamples;
    RenderSettings settings = settingsFor(size, kSamples);
    const double fixed = acceptedShare(renderScene(scene, settings).image, truth, kHidden);
    settings.samples = 1;
    settings.targetError = 0.002;
    // A pixel of an adaptive image may be off by the target where the oracle's is not.
    const double adaptive =
        acceptedShare(renderScene(scene, settings).image, truth, std::hypot(kHidden, 0.002));
    EXPECT_GE(fixed, 0.9975) << name;
    EXPECT_GE(adaptive, 0.9975) << name;
    std::cout << name << ": " << 100.0 * fixed << " % of the pixels accepted, adaptive " << 100.0 * adaptive
              << " %\n";
  }
}

// Over scenes, targets and seeds, the true error is at most the target, and not far below it.
TEST(Sampling, HonoursTargetErrors) {
  int runs = 0;
  int honoured = 0;
  int wasteful = 0;
  for (const char* name : {"extensions", "spheres", "horizon"}) {
    const Scene scene = readNamed(name);
    const ImageSize size = reducedSize(scene.camera, 120);
    RenderSettings reference = settingsFor(size, 1024);
    reference.seed = 4711;
    const Image truthImage = renderScene(scene, reference).image;
    const std::vector<double> truth(truthImage.rgb.begin(), truthImage.rgb.end());
    for (const double target : {0.02, 0.01, 0.005}) {
      for (std::uint32_t seed = 0; seed < 3; ++seed) {
        RenderSettings settings = settingsFor(size, 1);
        settings.targetError = target;
        settings.seed = seed;
        const double error = rmse(renderScene(scene, settings).image, truth);
        ++runs;
        honoured += error <= target ? 1 : 0;
        wasteful += error < target / 3.0 ? 1 : 0;
      }
    }
  }
  EXPECT_GE(honoured, 0.95 * runs);
  EXPECT_LE(wasteful, 0.2 * runs);
  std::cout << honoured << " of " << runs << " runs at or below their target, " << wasteful
            << " below a third\n";
}

}  // namespace
}  // namespace lavaray
