#include "image/false_color.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "image/color_spaces.hpp"

namespace lavaray {
namespace {

float lightness(const glm::vec3& srgb) {
  return labFromLinear({linearFromSrgb(srgb.r), linearFromSrgb(srgb.g), linearFromSrgb(srgb.b)}).x;
}

// A value that is larger by a hundredth is lighter by a unit in the mean, and by a third of it anywhere.
TEST(FalseColor, GrowsLighterAllTheWay) {
  EXPECT_EQ(falseColor(0.0F), glm::vec3(0.0F));
  EXPECT_EQ(falseColor(1.0F), glm::vec3(1.0F));
  for (int i = 0; i < 100; ++i) {
    const auto value = static_cast<float>(i);
    const float step = lightness(falseColor((value + 1.0F) / 100.0F)) - lightness(falseColor(value / 100.0F));
    EXPECT_GT(step, 0.33F) << "after " << i << " hundredths";
    EXPECT_LT(step, 1.6F) << "after " << i << " hundredths";
  }
}

TEST(FalseColor, IsThatOfEachPixel) {
  std::vector<float> rgb{0.25F, 0.25F, 0.25F, 2.0F, 2.0F, 2.0F};
  applyFalseColors(rgb);
  const glm::vec3 quarter = falseColor(0.25F);
  EXPECT_EQ(rgb, (std::vector<float>{quarter.r, quarter.g, quarter.b, 1.0F, 1.0F, 1.0F}));
}

}  // namespace
}  // namespace lavaray
