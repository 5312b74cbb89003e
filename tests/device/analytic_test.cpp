// Sampled images against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "device/lit_walls.hpp"
#include "device/render_scene.hpp"
#include "device/sampled_image.hpp"
#include "support/closed_forms.hpp"

namespace lavaray {
namespace {

// The image of a sphere covers an ellipse whose area is known.
TEST(Analytic, GivesTheAreaOfASpheresImage) {
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
  std::cout << "area off by " << area / expected - 1.0 << " of it, radius " << radius << " pixels\n";
}

void expectProfile(const Penumbra& penumbra, const std::string& name) {
  const Image image = renderScene(penumbra.scene, settingsFor(penumbra.size, 256)).image;
  const double contrast = penumbra.color(1.0) - penumbra.color(0.0);
  double largest = 0.0;
  double squares = 0.0;
  int partial = 0;
  int plain = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double expected = penumbra.expected(x, y);
      const std::size_t pixel = static_cast<std::size_t>(y) * image.width + x;
      const double error = std::abs(double{image.rgb[3 * pixel]} - penumbra.color(expected)) / contrast;
      largest = std::max(largest, error);
      if (penumbra.isPlain(x, y)) {
        EXPECT_LE(error, 1e-6) << name << " at " << x << ',' << y;
        ++plain;
      } else {
        squares += error * error;
        ++partial;
      }
    }
  }
  EXPECT_LE(largest, 0.025) << name;
  EXPECT_GT(partial, image.width / 2) << name;
  std::cout << name << ": largest error " << largest << ", RMSE " << std::sqrt(squares / partial) << " in "
            << partial << " pixels of the penumbra, " << plain << " without\n";
}

TEST(Analytic, PenumbraOfAHalfPlane) {
  for (const double radius : {2.0, 0.5, 0.02}) {
    expectProfile(halfPlanePenumbra(radius, {200, 4}), "light of radius " + std::to_string(radius));
  }
}

TEST(Analytic, PenumbraOfABall) {
  for (const double lightRadius : {0.8, 0.2}) {
    for (const double ballRadius : {0.6, 0.1}) {
      expectProfile(
          ballPenumbra(lightRadius, ballRadius, {200, 4}),
          "light of radius " + std::to_string(lightRadius) + ", ball of " + std::to_string(ballRadius));
    }
  }
}

// A spherical light's term is a mean that is clamped afterwards. The same scene, four times darker, is never
// clamped: its mean times four, clamped here, is what the bright one must show.
TEST(Analytic, ClampsTheMeanOfALightNotItsParts) {
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

// The image: three pixels side by side, each 10 x 10 units of the plane z = -5 that it sees. The first has an
// edge, the second a square of 0.1 x 0.1, the third nothing; behind them is a wall.
constexpr double kRise = 0.37;
const glm::dvec3 kWallColor(0.7, 0.0, 0x1p-30);

Scene sceneOfThreePixels() {
  Scene scene;
  scene.camera = {{0, 0, 0}, 90.0, 0.5, 3.0};
  scene.planes = {{{0, 0, 1}, {0, 0, -6}, addObject(scene, glow(kWallColor))}};
  // Below the line y = kRise (x + 10), which passes through the first pixel's centre; the other two edges are
  // out of its sight.
  scene.triangles = {{{{{-25, -15 * kRise, -5}, {-5, 5 * kRise, -5}, {-5, -60, -5}}},
                      addObject(scene, glow(glm::dvec3(1.0, 1.0, 0.0)))}};
  addParallelogram(scene, glow(glm::dvec3(0.7, 1.0, 0x1p-30)), {1.2, -2.1, -5}, {1.3, -2.1, -5},
                   {1.3, -2.0, -5});
  return scene;
}

constexpr std::uint32_t kMillion = 1000000;

// A float32 sum of a million samples is off by thousandths; that of the four of a work item by its last
// place.
TEST(Analytic, AMillionSamplesLoseNoSmallTerm) {
  const Scene scene = sceneOfThreePixels();
  const Image image = renderScene(scene, settingsFor({3, 1}, kMillion)).image;
  const auto value = [&](int pixel, int channel) { return double{image.rgb[3 * pixel + channel]}; };
  const double covered = halfPlaneCoverage(-0.5, -0.5, kRise, -1.0, 0.0);
  std::cout << "edge off by " << value(0, 1) - covered << ", square of 1e-4 by " << value(1, 1) - 1e-4
            << ", 0.7 by " << value(2, 0) - 0.7 << '\n';
  EXPECT_NEAR(value(0, 1), covered, 1e-5);
  EXPECT_NEAR(value(1, 1), 1e-4, 1e-5);
  for (const int pixel : {1, 2}) {
    EXPECT_NEAR(value(pixel, 0), 0.7, 2e-7);
    EXPECT_EQ(value(pixel, 2), 0x1p-30);
  }
  EXPECT_EQ(value(2, 1), 0.0);
}

TEST(Analytic, AMillionSamplesOfSmoothShading) {
  const MatteWall wall = matteWall(4);
  RenderSettings settings = settingsFor({4, 4}, kMillion);
  settings.crop = {3, 1, 4, 2};
  const double shown = renderScene(wall.scene, settings).image.rgb[0];
  const double off = shown - meanOverSquare(3, 1, wall.shading);
  std::cout << "off by " << off << '\n';
  EXPECT_LE(std::abs(off), 1e-6);
}

// Four pixels of a penumbra that is 3,333 pixels wide. Where it is narrow the position in the pixel matters
// as well as the direction to the light, and the error falls more slowly.
TEST(Analytic, AMillionSamplesOfAPenumbra) {
  const Penumbra penumbra = halfPlanePenumbra(0.5, {4000, 4000});
  RenderSettings settings = settingsFor(penumbra.size, kMillion);
  settings.crop = {1700, 2000, 1702, 2002};
  const Image image = renderScene(penumbra.scene, settings).image;
  double off = 0.0;
  for (int i = 0; i < 4; ++i) {
    const double expected = penumbra.color(penumbra.expected(1700 + i % 2, 2000 + i / 2));
    off += (double{image.rgb[3 * i]} - expected) / 4.0;
  }
  std::cout << "off by " << off << '\n';
  EXPECT_LE(std::abs(off), 1e-5);
}

}  // namespace
}  // namespace lavaray
