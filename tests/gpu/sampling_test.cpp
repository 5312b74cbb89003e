// Sampled images from the device: determinism, convergence, and agreement with the oracle and with closed
// forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iostream>

#include "core/scene_reader.hpp"
#include "gpu/render_scene.hpp"
#include "oracle/oracle.hpp"

namespace lavaray {
namespace {

Scene readNamed(const std::string& name) {
  return readScene(std::filesystem::path(LAVARAY_SCENES_DIR) / (name + ".txt"));
}

RenderSettings settingsFor(const ImageSize& size, std::uint32_t samples) {
  RenderSettings settings;
  settings.size = size;
  settings.crop = {0, 0, size.width, size.height};
  settings.samples = samples;
  return settings;
}

bool sameBits(const Image& a, const Image& b) {
  return a.rgb.size() == b.rgb.size() &&
         std::memcmp(a.rgb.data(), b.rgb.data(), a.rgb.size() * sizeof(float)) == 0;
}

double rmse(const Image& image, const std::vector<double>& truth) {
  double squares = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) squares += std::pow(double{image.rgb[i]} - truth[i], 2.0);
  return std::sqrt(squares / static_cast<double>(truth.size()));
}

// Slope of log error against log samples, least squares.
double slope(const std::vector<double>& samples, const std::vector<double>& errors) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double x = std::log(samples[i]);
    const double y = std::log(errors[i]);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  const auto n = static_cast<double>(samples.size());
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

TEST(Sampling, IsTheSameTwiceAndInParts) {
  const Scene scene = readNamed("extensions");
  const ImageSize size = reducedSize(scene.camera, 120);
  for (const std::uint32_t samples : {2U, 5U, 70U}) {
    RenderSettings settings = settingsFor(size, samples);
    settings.filter = PixelFilter::kGaussian;
    const Image whole = renderScene(scene, settings).image;
    EXPECT_TRUE(sameBits(whole, renderScene(scene, settings).image)) << samples;
    settings.crop = {31, 17, 64, 50};
    EXPECT_TRUE(sameBits(crop(whole, settings.crop), renderScene(scene, settings).image)) << samples;
  }
}

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

// A dark image with a bright half-plane: each pixel's truth is the share of it that the half-plane covers.
TEST(Sampling, ConvergesOnEdgesAsScrambledNetsDo) {
  Scene scene;
  scene.camera = {{0, 0, 0}, 90.0, 32.0, 1.0};
  scene.materials.push_back({glm::dvec3(1.0), glm::dvec3(0.0), glm::dvec3(0.0), 1.0});
  // Its edge runs through (0, 0) with a slope of 0.3 on the image plane; the other two are out of sight.
  scene.triangles.push_back({{{{-100, -30, -1}, {100, 30, -1}, {0, 200, -1}}}, 0});
  const ImageSize size{64, 64};
  RenderSettings reference = settingsFor(size, 8192);
  reference.seed = 99;
  const Image truthImage = renderScene(scene, reference).image;
  const std::vector<double> truth(truthImage.rgb.begin(), truthImage.rgb.end());
  std::vector<double> counts;
  std::vector<double> errors;
  for (std::uint32_t samples = 4; samples <= 1024; samples *= 4) {
    counts.push_back(samples);
    errors.push_back(rmse(renderScene(scene, settingsFor(size, samples)).image, truth));
  }
  // About 64 sqrt(1 + 0.3^2) of the 4,096 pixels are crossed by the edge.
  const double perEdgePixel = std::sqrt(64.0 * 64.0 / (64.0 * 1.3));
  EXPECT_LE(slope(counts, errors), -0.70);
  EXPECT_LE(errors[1] * perEdgePixel, 0.045);
  std::cout << "slope " << slope(counts, errors) << ", RMSE at 16 samples in the edge's pixels "
            << errors[1] * perEdgePixel << '\n';
}

// The image of a sphere covers an ellipse whose area is known.
TEST(Sampling, GivesTheAreaOfASpheresImage) {
  Scene scene;
  const double focalLength = 500.0;
  scene.camera = {
      {0, 0, 0}, 2.0 * std::atan(256.0 / focalLength) * 180.0 / std::acos(-1.0), focalLength, 1.0};
  scene.materials.push_back({glm::dvec3(1.0), glm::dvec3(0.0), glm::dvec3(0.0), 1.0});
  scene.spheres.push_back({{0, 0, -5}, 2.0, 0});
  const Image image = renderScene(scene, settingsFor(imageSize(scene.camera).value(), 64)).image;
  double area = 0.0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) area += image.rgb[i];
  // On the axis the silhouette is a circle: tan of its angle is r / sqrt(d^2 - r^2).
  const double radius = focalLength * 2.0 / std::sqrt(25.0 - 4.0);
  const double expected = std::acos(-1.0) * radius * radius;
  EXPECT_NEAR(area / expected, 1.0, 1e-4);
  std::cout << "area " << area / expected << " of the ellipse's, radius " << radius << " pixels\n";
}

// Between two facing mirrors each bounce adds the same light, k times weaker.
TEST(Sampling, FacingMirrorsGiveAGeometricSeries) {
  constexpr double kReflectance = 0.9;
  Scene scene;
  scene.camera = {{0, 0, 0}, 60.0, 20.0, 1.0};
  scene.materials.resize(2);
  for (Material& material : scene.materials) {
    material.ambient = glm::dvec3(0.01);
    material.reflectance = glm::dvec3(kReflectance);
  }
  scene.planes = {{{0, 0, 1}, {0, 0, -1}, 0}, {{0, 0, 1}, {0, 0, 1}, 1}};
  double before = 0.0;
  for (const std::uint32_t depth : {0U, 1U, 2U, 8U, 32U}) {
    RenderSettings settings = settingsFor({21, 21}, 1);
    settings.maxDepth = depth;
    const Image image = renderScene(scene, settings).image;
    const double expected = 0.01 * (1.0 - std::pow(kReflectance, depth + 1)) / (1.0 - kReflectance);
    for (const float value : image.rgb) ASSERT_NEAR(value, expected, 1e-6) << depth;
    EXPECT_GE(expected, before);
    before = expected;
  }
}

// A spherical light's term is a mean that is clamped afterwards. The same scene, four times darker, is never
// clamped: its mean times four, clamped here, is what the bright one must show.
TEST(Sampling, ClampsTheMeanOfALightNotItsParts) {
  const auto sceneOf = [](double brightness) {
    Scene scene;
    // A wall that fills the image, with the half-shadow of a sphere beside it.
    scene.camera = {{0, 0, 0}, 40.0, 60.0, 1.2};
    scene.materials = {{glm::dvec3(0.5 * brightness), glm::dvec3(1.8 * brightness), glm::dvec3(0.0), 1.0},
                       {glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0), 1.0}};
    scene.planes = {{{0, 0, 1}, {0, 0, -10}, 0}};
    scene.spheres = {{{6, 0, -6}, 1.0, 1}};
    scene.lights.push_back({{12, 0, -2}, glm::dvec3(0.0), glm::dvec3(1.0), glm::dvec3(0.0), 1.5});
    return scene;
  };
  const ImageSize size = reducedSize(sceneOf(1.0).camera, 60);
  const Image dark = renderScene(sceneOf(0.25), settingsFor(size, 1024)).image;
  std::vector<double> expected;
  for (const float value : dark.rgb) expected.push_back(std::min(1.0, 4.0 * double{value}));
  const Image bright = renderScene(sceneOf(1.0), settingsFor(size, 256)).image;
  EXPECT_LT(rmse(bright, expected), 0.01);
  std::cout << "RMSE " << rmse(bright, expected) << '\n';
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
