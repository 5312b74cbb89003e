// The parts of sampling that trace nothing: filters, sums, and the plan of adaptive sampling.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "film/pixel_sum.hpp"
#include "render/adaptive.hpp"
#include "render/pixel_filter.hpp"

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

gpu::WorkResult blackOrWhite(const gpu::WorkItem& item, double probabilityOfWhite, std::mt19937& random) {
  std::binomial_distribution<unsigned> hits(item.count, probabilityOfWhite);
  const auto white = static_cast<float>(hits(random));
  return {glm::vec3(white), white};
}

// Pixels that an edge crosses: sample i of either half is 1 with the edge's coverage as probability,
// stratified.
class EdgeImage {
 public:
  EdgeImage(int width, int height, unsigned seed) : coverage_(static_cast<std::size_t>(width) * height) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    // Every twentieth column has an edge of its own coverage, which divides 0 from 1.
    for (std::size_t i = 0; i < coverage_.size(); ++i) {
      const int x = static_cast<int>(i) % width;
      coverage_[i] = x % 20 == 10 ? uniform(random) : (x / 10 % 2 == 0 ? 0.0 : 1.0);
    }
  }
  [[nodiscard]] double truth(std::size_t pixel) const { return coverage_[pixel]; }
  [[nodiscard]] gpu::WorkResult sum(const gpu::WorkItem& item, std::mt19937& random) const {
    return blackOrWhite(item, coverage_[item.pixel], random);
  }

 private:
  std::vector<double> coverage_;
};

TEST(AdaptiveSampling, HonoursItsTargetAndSpendsOnEdges) {
  constexpr int kWidth = 200;
  constexpr int kHeight = 100;
  for (const double target : {0.02, 0.01, 0.005}) {
    const EdgeImage image(kWidth, kHeight, 1);
    std::mt19937 random(2);
    AdaptiveSampling adaptive(kWidth, kHeight, target, 1U << 20U, {});
    for (auto items = adaptive.nextItems(); !items.empty(); items = adaptive.nextItems()) {
      for (const gpu::WorkItem& item : items) adaptive.add(item, image.sum(item, random));
    }
    EXPECT_TRUE(adaptive.reachedTarget());
    double squares = 0.0;
    std::uint64_t onEdges = 0;
    std::uint64_t all = 0;
    for (std::size_t pixel = 0; pixel < kWidth * kHeight; ++pixel) {
      squares += std::pow(adaptive.mean(pixel).r - image.truth(pixel), 2.0);
      all += adaptive.samples(pixel);
      const auto x = pixel % kWidth;
      if (x % 20 >= 8 && x % 20 <= 12) onEdges += adaptive.samples(pixel);
    }
    const double error = std::sqrt(squares / (kWidth * kHeight));
    EXPECT_LE(error, target);
    EXPECT_GE(error, target / 3.0);
    EXPECT_GT(static_cast<double>(onEdges) / static_cast<double>(all), 0.5);
  }
}

TEST(AdaptiveSampling, LeavesAPlainImageAlone) {
  AdaptiveSampling adaptive(50, 40, 0.01, 1024, {});
  std::size_t passes = 0;
  for (auto items = adaptive.nextItems(); !items.empty(); items = adaptive.nextItems()) {
    for (const gpu::WorkItem& item : items) {
      const auto count = static_cast<float>(item.count);
      adaptive.add(item, {glm::vec3(0.25F * count), 0.0625F * count});
    }
    ++passes;
  }
  EXPECT_EQ(passes, 1U);
  EXPECT_TRUE(adaptive.reachedTarget());
  EXPECT_LE(adaptive.samples(0), 4U);
  EXPECT_EQ(adaptive.mean(7), glm::dvec3(0.25));
}

TEST(AdaptiveSampling, StopsAtTheMostSamplesAllowed) {
  AdaptiveSampling adaptive(20, 20, 1e-4, 64, {});
  std::mt19937 random(3);
  for (auto items = adaptive.nextItems(); !items.empty(); items = adaptive.nextItems()) {
    for (const gpu::WorkItem& item : items) adaptive.add(item, blackOrWhite(item, 0.5, random));
  }
  EXPECT_FALSE(adaptive.reachedTarget());
  for (std::size_t pixel = 0; pixel < 400; ++pixel) EXPECT_LE(adaptive.samples(pixel), 64U);
}

}  // namespace
}  // namespace lavaray
