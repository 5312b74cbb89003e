// What becomes of a pixel's samples before and after they are traced: where filters put them, and their sum.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "sampling/pixel_filter.hpp"
#include "sampling/pixel_sum.hpp"

namespace lavaray {
namespace {

TEST(PixelFilter, TablesAreSymmetricAndRise) {
  EXPECT_TRUE(filterTable(PixelFilter::kBox).empty());
  for (const PixelFilter filter :
       {PixelFilter::kTent, PixelFilter::kGaussian, PixelFilter::kBlackmanHarris}) {
    const std::vector<float> table = filterTable(filter);
    ASSERT_GE(table.size(), 3U);
    EXPECT_TRUE(std::is_sorted(table.begin(), table.end()));
    for (std::size_t i = 0; i < table.size(); ++i) EXPECT_NEAR(table[i], -table[table.size() - 1 - i], 1e-4F);
  }
}

// Of the tent's distribution a share of 1/8 lies below -1/2, and its inverse is a square root.
TEST(PixelFilter, TentIsTheClosedForm) {
  const std::vector<float> table = filterTable(PixelFilter::kTent);
  const std::size_t last = table.size() - 1;
  for (std::size_t i = 0; i <= last / 2; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(last);
    EXPECT_NEAR(table[i], std::sqrt(2.0 * share) - 1.0, 1e-4);
  }
}

TEST(PixelFilter, GaussianHasItsWidth) {
  const std::vector<float> table = filterTable(PixelFilter::kGaussian);
  double squares = 0.0;
  for (const float x : table) squares += double{x} * double{x};
  // A standard deviation of 1/2, a little less for the cut-off tails.
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(table.size())), 0.48, 0.02);
}

TEST(PixelSum, DoesNotDependOnOrderOrGrouping) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> value(0.0F, 1.0F);
  std::vector<glm::vec3> samples(10000);
  for (glm::vec3& sample : samples) sample = {value(random), value(random) * 1e-6F, value(random) * 1e-9F};
  PixelSum forward;
  for (const glm::vec3& sample : samples) forward.add(sample, 1);
  PixelSum halves[2];
  for (std::size_t i = samples.size(); i-- > 0;) halves[i % 2].add(samples[i], 1);
  halves[0].add(halves[1]);
  EXPECT_EQ(forward.mean(), halves[0].mean());
}

TEST(PixelSum, KeepsSmallTermsAmongAMillion) {
  PixelSum sum;
  for (int i = 0; i < 1000000; ++i) sum.add(glm::vec3(i == 0 ? 1.0F : 0.0F, 1.0F, 1e-6F), 1);
  EXPECT_EQ(sum.mean().r, 1e-6);
  EXPECT_EQ(sum.mean().g, 1.0);
  EXPECT_NEAR(sum.mean().b, 1e-6, 1e-12);
}

}  // namespace
}  // namespace lavaray
