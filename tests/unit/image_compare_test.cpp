#include "support/image_compare.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "oracle/oracle.hpp"

namespace lavaray {
namespace {

using glm::dvec3;
using oracle::Pixel;

TEST(ImageCompare, CountsCertainPixelsThatAreOff) {
  oracle::Result expected{2, 2, std::vector<Pixel>(4, {dvec3(0.5), false})};
  expected.pixels[3].uncertain = true;
  std::vector<float> rgb(12, 0.5F);
  EXPECT_EQ(compare(rgb, expected).wrong, 0);
  rgb[1] += 0.9F / 255.0F;  // less than a level
  rgb[5] += 2.0F / 255.0F;
  rgb[6] = std::numeric_limits<float>::quiet_NaN();
  rgb[9] = 0.0F;  // uncertain
  const Comparison comparison = compare(rgb, expected);
  EXPECT_EQ(comparison.total, 4);
  EXPECT_EQ(comparison.uncertain, 1);
  EXPECT_EQ(comparison.wrong, 2);
  EXPECT_EQ(comparison.maxX, 0);
  EXPECT_EQ(comparison.maxY, 1);
  rgb.pop_back();
  EXPECT_THROW(compare(rgb, expected), std::invalid_argument);
}

TEST(ImageCompare, KnowsWhatIsOnTheOtherSideOfAnEdge) {
  // A ray at the horizon of a plane may see it or miss it.
  Scene scene;
  scene.camera = {{0, 0, 0}, 90.0, 1.5, 1.0};
  scene.materials = {{.ambient = {0.5, 0.25, 0.75}}};
  scene.planes = {{{0, 1, 0}, {0, -1, 0}, 0}};
  const oracle::Result image = oracle::render(scene);
  ASSERT_EQ(image.height, 3);
  const Pixel& horizon = image.pixels[4];
  ASSERT_TRUE(horizon.uncertain);
  EXPECT_TRUE(showsAlternative({0.0F, 0.0F, 0.0F}, 0, horizon));
  EXPECT_TRUE(showsAlternative({0.5F, 0.25F, 0.75F}, 0, horizon));
  EXPECT_FALSE(showsAlternative({0.25F, 0.125F, 0.375F}, 0, horizon));
  EXPECT_FALSE(showsAlternative({0.5F, 0.25F, std::numeric_limits<float>::quiet_NaN()}, 0, horizon));
  EXPECT_FALSE(showsAlternative({0.5F, 0.25F, 0.75F}, 0, image.pixels[7]));  // certain
}

TEST(ImageCompare, ForgivesEdgesOfByteImages) {
  oracle::Result oracle{4, 1, std::vector<Pixel>(4, {dvec3(0.5), false})};
  const std::vector<std::uint8_t> expected = truncatedBytes(oracle);
  EXPECT_EQ(expected, std::vector<std::uint8_t>(12, 127));
  EXPECT_EQ(truncatedBytes(oracle, true), std::vector<std::uint8_t>(12, 255));
  oracle.pixels[0].uncertain = true;
  std::vector<std::uint8_t> actual = expected;
  actual[4] = 0;    // next to the edge
  actual[8] = 126;  // one level
  actual[11] = 130;
  const ByteComparison comparison = compareBytes(actual, expected, oracle);
  EXPECT_EQ(comparison.differing, 3);
  EXPECT_EQ(comparison.maxDifference, 127);
  EXPECT_EQ(comparison.wrong, 1);
}

}  // namespace
}  // namespace lavaray
