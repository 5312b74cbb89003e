#include "image/flip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "image/color_spaces.hpp"
#include "image/mean_flip.hpp"

namespace lavaray {
namespace {

Image constantImage(int width, int height, const glm::vec3& color) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i) image.rgb.insert(image.rgb.end(), {color.r, color.g, color.b});
  return image;
}

Image noise(int width, int height, std::uint32_t seed, float amplitude) {
  std::mt19937 random(seed);
  Image image{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) {
    image.rgb.push_back(0.5F + amplitude * (static_cast<float>(random() % 256) / 255.0F - 0.5F));
  }
  return image;
}

// FLIP as the paper states it, in double precision, every filter as one sum over a square of pixels.
class PlainFlip {
 public:
  static std::vector<double> map(const Image& image, const Image& reference) {
    const PlainFlip a(image);
    const PlainFlip b(reference);
    const double largest = std::pow(hyab(hunt(lab({0, 1, 0})), hunt(lab({0, 0, 1}))), 0.7);
    std::vector<double> result;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const double distance = std::pow(hyab(a.color(x, y), b.color(x, y)), 0.7);
        const double knee = 0.4 * largest;
        const double colors =
            distance < knee ? distance * 0.95 / knee : 0.95 + (distance - knee) / (largest - knee) * 0.05;
        const double edges = std::abs(a.feature(x, y, false) - b.feature(x, y, false));
        const double points = std::abs(a.feature(x, y, true) - b.feature(x, y, true));
        const double features = std::sqrt(std::max(edges, points) / std::sqrt(2.0));
        result.push_back(std::pow(colors, 1.0 - features));
      }
    }
    return result;
  }

 private:
  static constexpr double kPi = 3.14159265358979;
  static constexpr double kPixelsPerDegree = 67.0206;
  static constexpr int kReach = 10;
  const glm::dvec3 white_{0.95043, 1.0, 1.08890};
  // Columns are red, green and blue.
  const glm::dmat3 toXyz_{0.4123866, 0.2126372, 0.0193307, 0.3575915, 0.7151830,
                          0.1191972, 0.1804505, 0.0721802, 0.9503726};

  explicit PlainFlip(const Image& image) : image_(image) {}

  static double root(double t) {
    return t > std::pow(6.0 / 29.0, 3) ? std::cbrt(t) : t * 841.0 / 108.0 + 4.0 / 29.0;
  }
  static glm::dvec3 lab(const glm::dvec3& linear) { return PlainFlip(Image{}).labOf(linear); }
  [[nodiscard]] glm::dvec3 labOf(const glm::dvec3& linear) const {
    const glm::dvec3 xyz = toXyz_ * linear / white_;
    return {116.0 * root(xyz.y) - 16.0, 500.0 * (root(xyz.x) - root(xyz.y)),
            200.0 * (root(xyz.y) - root(xyz.z))};
  }
  static glm::dvec3 hunt(const glm::dvec3& lab) {
    return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
  }
  static double hyab(const glm::dvec3& a, const glm::dvec3& b) {
    return std::abs(a.x - b.x) + glm::length(glm::dvec2(a.y - b.y, a.z - b.z));
  }

  // YCxCz of a pixel; beyond the sides that of the nearest one.
  [[nodiscard]] glm::dvec3 ycxcz(int x, int y) const {
    glm::dvec3 linear;
    for (int channel = 0; channel < 3; ++channel) {
      const int pixel =
          std::clamp(y, 0, image_.height - 1) * image_.width + std::clamp(x, 0, image_.width - 1);
      const double v = image_.rgb[static_cast<std::size_t>(3 * pixel + channel)];
      linear[channel] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    const glm::dvec3 xyz = toXyz_ * linear / white_;
    return {116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z)};
  }

  static double sensitivity(double a1, double b1, double a2, double b2, double squaredPixels) {
    const double z = squaredPixels / (kPixelsPerDegree * kPixelsPerDegree);
    return a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * z / b1) +
           a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * z / b2);
  }

  [[nodiscard]] glm::dvec3 color(int x, int y) const {
    glm::dvec3 sum(0.0);
    glm::dvec3 weights(0.0);
    for (int v = -kReach; v <= kReach; ++v) {
      for (int u = -kReach; u <= kReach; ++u) {
        const double squared = u * u + v * v;
        const glm::dvec3 weight(sensitivity(1.0, 0.0047, 0.0, 1e-5, squared),
                                sensitivity(1.0, 0.0053, 0.0, 1e-5, squared),
                                sensitivity(34.1, 0.04, 13.5, 0.025, squared));
        sum += weight * ycxcz(x + u, y + v);
        weights += weight;
      }
    }
    const glm::dvec3 seen = sum / weights;
    const double luminance = (seen.x + 16.0) / 116.0;
    const glm::dvec3 xyz =
        white_ * glm::dvec3(seen.y / 500.0 + luminance, luminance, luminance - seen.z / 200.0);
    glm::dvec3 linear = glm::inverse(toXyz_) * xyz;
    for (int channel = 0; channel < 3; ++channel) linear[channel] = std::clamp(linear[channel], 0.0, 1.0);
    return hunt(labOf(linear));
  }

  // The length of the gradient of edges or of points.
  [[nodiscard]] double feature(int x, int y, bool points) const {
    const double deviation = 0.5 * 0.082 * kPixelsPerDegree;
    const int reach = static_cast<int>(std::ceil(3.0 * deviation));
    // By sign of the weights: their sums, and the sums of the weighted luminances along x and y.
    std::array<double, 2> totals{};
    std::array<glm::dvec2, 2> sums{glm::dvec2(0.0), glm::dvec2(0.0)};
    for (int v = -reach; v <= reach; ++v) {
      for (int u = -reach; u <= reach; ++u) {
        const double gaussian = std::exp(-(u * u + v * v) / (2.0 * deviation * deviation));
        const double luminance = (ycxcz(x + u, y + v).x + 16.0) / 116.0;
        const auto weight = [&](double t) {
          return gaussian * (points ? t * t / (deviation * deviation) - 1.0 : -t);
        };
        totals[weight(u) < 0.0] += std::abs(weight(u));
        sums[weight(u) < 0.0].x += weight(u) * luminance;
        sums[weight(v) < 0.0].y += weight(v) * luminance;
      }
    }
    return glm::length(sums[0] / totals[0] + sums[1] / totals[1]);
  }

  const Image image_;
};

TEST(Flip, IsThatOfThePaper) {
  const Image reference = noise(37, 29, 1, 1.0F);
  for (const Image& image : {noise(37, 29, 2, 1.0F), noise(37, 29, 3, 0.1F)}) {
    const std::vector<float> map = flipMap(image, reference, 2);
    const std::vector<double> expected = PlainFlip::map(image, reference);
    ASSERT_EQ(map.size(), expected.size());
    for (std::size_t i = 0; i < map.size(); ++i) EXPECT_NEAR(map[i], expected[i], 2e-4) << "pixel " << i;
  }
}

TEST(Flip, IsZeroForEqualImagesOnly) {
  const Image image = noise(50, 70, 4, 1.0F);
  EXPECT_EQ(meanFlip(image, image, 1), 0.0);
  Image other = image;
  other.rgb[300] = other.rgb[300] > 0.5F ? 0.0F : 1.0F;
  EXPECT_GT(meanFlip(image, other, 1), 0.0);
}

TEST(Flip, IsOneForTheMostDifferentColors) {
  const Image green = constantImage(20, 15, {0.0F, 1.0F, 0.0F});
  const Image blue = constantImage(20, 15, {0.0F, 0.0F, 1.0F});
  for (const float flip : flipMap(green, blue, 1)) EXPECT_NEAR(flip, 1.0F, 1e-4);
}

TEST(Flip, DoesNotDependOnOrderOrThreads) {
  // More rows than are done at a time.
  const Image a = noise(40, 200, 5, 1.0F);
  const Image b = noise(40, 200, 6, 0.7F);
  const std::vector<float> map = flipMap(a, b, 1);
  EXPECT_EQ(flipMap(b, a, 1), map);
  EXPECT_EQ(flipMap(a, b, 3), map);
}

TEST(Flip, OfWhatIsNotANumberIsNone) {
  Image image = constantImage(30, 30, glm::vec3(0.5F));
  const Image reference = image;
  image.rgb[3 * (30 * 15 + 15)] = NAN;
  EXPECT_TRUE(std::isnan(flipMap(image, reference, 1)[30 * 15 + 15]));
}

TEST(PerceptualColor, KnowsTheColorsOfTheTables) {
  const auto expectLab = [](const glm::vec3& linear, const glm::vec3& expected) {
    const glm::vec3 lab = labFromLinear(linear);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(lab[i], expected[i], 0.02F);
  };
  expectLab({1.0F, 1.0F, 1.0F}, {100.0F, 0.0F, 0.0F});
  expectLab({0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
  expectLab({1.0F, 0.0F, 0.0F}, {53.24F, 80.09F, 67.20F});
  expectLab({0.0F, 1.0F, 0.0F}, {87.73F, -86.18F, 83.18F});
  expectLab({0.0F, 0.0F, 1.0F}, {32.30F, 79.19F, -107.86F});
  EXPECT_NEAR(linearFromSrgb(0.5F), 0.21404F, 1e-5F);
  EXPECT_NEAR(linearFromSrgb(0.04F), 0.0030960F, 1e-6F);
}

TEST(PerceptualColor, OpponentColorsCanBeUndone) {
  for (const glm::vec3& color : {glm::vec3(0.2F, 0.7F, 0.1F), glm::vec3(1.0F, 0.0F, 0.5F)}) {
    const glm::vec3 back = linearFromOpponent(opponentFromLinear(color));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(back[i], color[i], 1e-6F);
  }
}

}  // namespace
}  // namespace lavaray
