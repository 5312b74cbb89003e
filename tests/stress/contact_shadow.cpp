// Shadows begin where things touch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "device/render_scene.hpp"
#include "oracle/oracle.hpp"
#include "scene/camera.hpp"
#include "stress/frame.hpp"
#include "stress/report.hpp"

namespace lavaray {
namespace {

// The longest row or column of pixels that `isWrong` is true of.
template <typename IsWrong>
int longestRun(const Rectangle& area, const IsWrong& isWrong) {
  int longest = 0;
  const auto scan = [&](int lines, int length, const auto& pixel) {
    for (int line = 0; line < lines; ++line) {
      int run = 0;
      for (int i = 0; i < length; ++i) {
        run = pixel(line, i) ? run + 1 : 0;
        longest = std::max(longest, run);
      }
    }
  };
  const int width = area.width();
  const int height = area.height();
  scan(height, width, [&](int y, int x) { return isWrong(x, y); });
  scan(width, height, [&](int x, int y) { return isWrong(x, y); });
  return longest;
}

// A sphere that rests on a plane, seen from `distance` and `height`, so that it has the same size in the
// picture.
Scene restingSphere(double distance, double height, const glm::dvec3& toLight, const Frame& frame) {
  Scene scene;
  const double focalLength = 540.0 * std::sqrt(3.0) * distance / 6.0;
  const double fovDegrees = 2.0 * std::atan(540.0 / focalLength) * 180.0 / std::numbers::pi;
  scene.camera = {{0.0, 0.0, 0.0}, fovDegrees, focalLength, 1920.0 / 1080.0};
  const glm::dvec3 contact = glm::dvec3(0.0, -height, -distance);
  const glm::dvec3 up = frame.y;
  scene.materials = {{glm::dvec3(0.1), glm::dvec3(0.0), glm::dvec3(0.0), 1.0, {}},
                     {glm::dvec3(0.1), glm::dvec3(0.8), glm::dvec3(0.0), 1.0, {}}};
  scene.spheres = {{contact + up, 1.0, 0}};
  scene.planes = {{up, contact, 1}};
  scene.lights = {{contact + frame.at(toLight), glm::dvec3(0.5), glm::dvec3(1.0), glm::dvec3(0.0)}};
  return scene;
}

TEST(ContactShadow, BeginsWithinAPixelOfTheContact) {
  const Frame tilted{
      glm::normalize(glm::dvec3(1.0, -0.3, 0.0)), glm::normalize(glm::dvec3(0.3, 1.0, 0.0)), {0, 0, 1}};
  int worst = 0;
  std::size_t pixels = 0;
  std::size_t shadowed = 0;
  std::size_t gaps = 0;
  for (const Frame& frame : {Frame{}, tilted}) {
    for (const double distance : {6.0, 600.0}) {
      for (const double slope : {0.01, 0.2}) {
        for (const glm::dvec3& toLight : {glm::dvec3(0.0, 20.0, 0.0), glm::dvec3(3.0, 4.0, 5.0)}) {
          const Scene scene = restingSphere(distance, slope * distance, toLight, frame);
          ASSERT_EQ(imageSize(scene.camera), (ImageSize{1920, 1080}));
          // Around the contact, a third of the radius each way.
          const int row = 540 + static_cast<int>(935.0 * slope);
          const Rectangle area{910, row - 50, 1010, std::min(row + 50, 1080)};
          const Image image = renderScene(scene, ImageSize{1920, 1080}, area).image;
          const oracle::Result expected = oracle::render(
              scene, {.x0 = area.x0, .y0 = area.y0, .x1 = area.x1, .y1 = area.y1, .probeOffset = 0.0});
          const auto isDark = [](double value) { return value < 0.11; };
          const auto isGap = [&](int x, int y) {
            const std::size_t i = static_cast<std::size_t>(y) * expected.width + x;
            return isDark(expected.pixels[i].color.r) && !isDark(image.rgb[3 * i]);
          };
          worst = std::max(worst, longestRun(area, isGap));
          for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
            ++pixels;
            if (isDark(expected.pixels[i].color.r)) ++shadowed;
            if (isGap(static_cast<int>(i) % expected.width, static_cast<int>(i) / expected.width)) ++gaps;
          }
        }
      }
    }
  }
  EXPECT_LE(worst, 1);
  EXPECT_GT(shadowed, pixels / 10);
  EXPECT_LT(shadowed, pixels);
  report("a gap of " + std::to_string(worst) + " pixels at most at 1920 x 1080; " + grouped(gaps) + " of " +
         grouped(shadowed) + " shadowed pixels next to contacts are lit");
}

}  // namespace
}  // namespace lavaray
