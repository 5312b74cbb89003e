#include "scene/camera.hpp"

#include <gtest/gtest.h>

#include "base/limits.hpp"

namespace lavaray {
namespace {

Camera camera(double focalLength, double fovDegrees, double aspect) {
  return {
      .position = glm::dvec3(0.0), .fovDegrees = fovDegrees, .focalLength = focalLength, .aspect = aspect};
}

// The sizes of the course's expected images.
TEST(ImageSize, FitsTheCourse) {
  EXPECT_EQ(imageSize(camera(1000, 60, 1.33)), (ImageSize{1534, 1154}));
  EXPECT_EQ(imageSize(camera(500, 60, 1.33)), (ImageSize{767, 577}));
  EXPECT_EQ(imageSize(camera(700, 60, 1.5)), (ImageSize{1212, 808}));
  EXPECT_EQ(imageSize(camera(400, 60, 1.33)), (ImageSize{613, 461}));
  EXPECT_EQ(imageSize(camera(200, 60, 1.33)), (ImageSize{305, 230}));
  EXPECT_EQ(imageSize(camera(1000, 60, 1.7778)), (ImageSize{2051, 1154}));
}

TEST(ImageSize, RightAngleLosesNoRow) {
  for (int half = 1; half <= 2000; ++half) {
    EXPECT_EQ(imageSize(camera(half, 90, 1)), (ImageSize{2 * half, 2 * half}));
  }
}

TEST(ImageSize, WidthIsOfTheTruncatedHeight) {
  EXPECT_EQ(imageSize(camera(0.95, 90, 2)), (ImageSize{2, 1}));
}

TEST(ImageSize, NothingOutsideTheLimits) {
  EXPECT_EQ(imageSize(camera(0.4, 90, 1)), std::nullopt);
  EXPECT_EQ(imageSize(camera(10, 90, 0.01)), std::nullopt);
  EXPECT_EQ(imageSize(camera(10, 1e-300, 1)), std::nullopt);
  EXPECT_EQ(imageSize(camera(1e15, 179.99999999999997, 1e15)), std::nullopt);
  EXPECT_EQ(imageSize(camera(1e-300, 90, 1e15)), std::nullopt);
  const double largest = kMaxImageSide;
  EXPECT_EQ(imageSize(camera(largest / 2, 90, 1)), (ImageSize{kMaxImageSide, kMaxImageSide}));
  EXPECT_EQ(imageSize(camera((largest + 1) / 2, 90, 0.5)), std::nullopt);
  EXPECT_EQ(imageSize(camera(largest / 4, 90, 2.1)), std::nullopt);
}

}  // namespace
}  // namespace lavaray
