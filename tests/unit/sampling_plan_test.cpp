// The plan of adaptive sampling, and the estimates that it goes by: pure arithmetic, which traces nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "sampling/adaptive_plan.hpp"
#include "sampling/error_estimate.hpp"
#include "sampling/pixel_sum.hpp"
#include "sampling/sample_sums.hpp"

namespace lavaray {
namespace {

gpu::WorkResult blackOrWhite(const gpu::WorkItem& item, double probabilityOfWhite, std::mt19937& random) {
  std::binomial_distribution<unsigned> hits(item.count, probabilityOfWhite);
  const auto white = static_cast<float>(hits(random));
  return {glm::vec3(white), white};
}

// A point of a two-dimensional Sobol sequence with a digital shift of its own, in the unit square.
struct SobolPoints {
  std::uint32_t shiftX;
  std::uint32_t shiftY;
  [[nodiscard]] glm::dvec2 at(std::uint32_t index) const {
    std::uint32_t x = shiftX;
    std::uint32_t y = shiftY;
    std::uint32_t columnX = 1U << 31U;
    std::uint32_t columnY = 1U << 31U;
    for (; index > 0; index /= 2) {
      if (index % 2 == 1) x ^= columnX, y ^= columnY;
      columnX >>= 1U;
      columnY ^= columnY >> 1U;
    }
    return {x * 0x1p-32, y * 0x1p-32};
  }
};

SobolPoints randomPoints(std::mt19937& random) {
  return {static_cast<std::uint32_t>(random()), static_cast<std::uint32_t>(random())};
}

// Every twentieth column has an edge of its own in each pixel, which divides 0 from 1: a sample at (x, y) in
// the unit square is 1 where x + slope * y < offset.
class EdgeImage {
 public:
  EdgeImage(int width, int height, unsigned seed) : edges_(static_cast<std::size_t>(width) * height) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const int x = static_cast<int>(i) % width;
      edges_[i].offset = x % 20 == 10 ? uniform(random) : (x / 10 % 2 == 0 ? 0.0 : 2.0);
      edges_[i].slope = x % 20 == 10 ? uniform(random) : 0.0;
      edges_[i].points = randomPoints(random);
    }
  }

  [[nodiscard]] double truth(std::size_t pixel) const {
    constexpr int kRows = 1000;
    double sum = 0.0;
    for (int row = 0; row < kRows; ++row) {
      const double y = (row + 0.5) / kRows;
      sum += std::clamp(edges_[pixel].offset - edges_[pixel].slope * y, 0.0, 1.0);
    }
    return sum / kRows;
  }

  [[nodiscard]] gpu::WorkResult independent(const gpu::WorkItem& item, std::mt19937& random) const {
    return blackOrWhite(item, truth(item.pixel), random);
  }

  // At the points of a two-dimensional Sobol sequence with a digital shift.
  [[nodiscard]] gpu::WorkResult stratified(const gpu::WorkItem& item) const {
    const Edge& edge = edges_[item.pixel];
    int hits = 0;
    for (std::uint32_t i = item.first; i < item.first + item.count; ++i) {
      const glm::dvec2 point = edge.points.at(i);
      hits += point.x + edge.slope * point.y < edge.offset ? 1 : 0;
    }
    return {glm::vec3(static_cast<float>(hits)), static_cast<float>(hits)};
  }

 private:
  struct Edge {
    double offset;
    double slope;
    SobolPoints points;
  };
  std::vector<Edge> edges_;
};

// The estimated error of an image against its true one, of `value` at points of the image with `samples` of a
// pixel.
template <typename Value>
double estimatedOverTrue(int samples, bool isStratified, const Value& value) {
  constexpr int kSize = 60;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<HalfSums> sums(kSize * kSize);
  double squares = 0.0;
  for (int pixel = 0; pixel < kSize * kSize; ++pixel) {
    const glm::dvec2 corner(pixel % kSize, pixel / kSize);
    const SobolPoints points = randomPoints(random);
    for (int i = 0; i < samples; ++i) {
      const glm::dvec2 independent(uniform(random), uniform(random));
      const auto sample = static_cast<float>(
          value(corner + (isStratified ? points.at(static_cast<std::uint32_t>(i)) : independent)));
      sums[pixel].halves[i >= samples / 2 && samples > 2 ? 1 : 0].add(glm::vec3(sample), 1);
      sums[pixel].squares += PixelSum::toFixedPoint(sample * sample);
    }
    constexpr int kGrid = 32;
    double truth = 0.0;
    for (int i = 0; i < kGrid * kGrid; ++i)
      truth += value(corner + glm::dvec2(i % kGrid + 0.5, i / kGrid + 0.5) / double{kGrid});
    PixelSum all = sums[pixel].halves[0];
    all.add(sums[pixel].halves[1]);
    squares += std::pow(all.mean().r - truth / (kGrid * kGrid), 2.0);
  }
  ErrorEstimate estimate(kSize, kSize, isStratified, 0.0);
  estimate.markAll();
  estimate.update(sums);
  double estimated = 0.0;
  const PictureScale scale = estimate.scale(sums, Discoveries());
  for (const PixelClass& pixel : estimate.classes()) estimated += scale.squaredError(pixel);
  return std::sqrt(estimated / squares);
}

// Stripes whose edges run through all pixels at several angles; shading that curves.
double stripes(const glm::dvec2& p) {
  return std::fmod(0.73 * p.x + 0.31 * p.y, 2.0) < 1.0 ? 0.2 : 0.8;
}
double shading(const glm::dvec2& p) {
  return 0.5 + 0.3 * std::sin(0.11 * p.x) * std::cos(0.07 * p.y);
}

TEST(ErrorEstimate, IsTheErrorAtEdgesOnShadingAndOfIndependentSamples) {
  for (const int samples : {2, 4, 8, 16, 64}) {
    const double edges = estimatedOverTrue(samples, true, stripes);
    const double smooth = estimatedOverTrue(samples, true, shading);
    const double independent = estimatedOverTrue(samples, false, stripes);
    std::cout << samples << " samples, estimated over true error: edges " << edges << ", smooth " << smooth
              << ", independent " << independent << "\n";
    EXPECT_GT(edges, 0.8);
    EXPECT_LT(edges, 1.5);
    EXPECT_GT(smooth, 0.7);
    EXPECT_LT(smooth, 1.5);
    EXPECT_NEAR(independent, 1.0, samples < 4 ? 0.25 : 0.1);
  }
}

// Takes the samples of all passes of the plan; returns how many passes there were.
template <typename Take>
std::size_t takeAll(AdaptivePlan& plan, SampleSums& sums, const Take& take) {
  std::size_t passes = 0;
  for (SamplePass pass = plan.nextPass(sums.halves()); pass.items > 0; pass = plan.nextPass(sums.halves())) {
    std::vector<gpu::WorkResult> results;
    for (const gpu::WorkItem& item : pass.list) results.push_back(take(item));
    sums.add(pass, 0, results);
    ++passes;
  }
  return passes;
}

glm::vec3 meanOf(const SampleSums& sums, std::uint64_t pixel) {
  glm::vec3 mean;
  sums.copyMeans(pixel, {&mean, 1});
  return mean;
}

TEST(AdaptivePlan, HonoursItsTargetAndSpendsOnEdges) {
  constexpr int kWidth = 200;
  constexpr int kHeight = 100;
  for (const bool isStratified : {true, false}) {
    for (const double target : {0.02, 0.01, 0.005}) {
      const EdgeImage image(kWidth, kHeight, 1);
      std::mt19937 random(2);
      AdaptivePlan plan({kWidth, kHeight}, {target, 1U << 20U, isStratified}, {});
      SampleSums sums(SumKind::kHalves, std::uint64_t{kWidth} * kHeight);
      takeAll(plan, sums, [&](const gpu::WorkItem& item) {
        return isStratified ? image.stratified(item) : image.independent(item, random);
      });
      EXPECT_TRUE(plan.reachedTarget());
      double squares = 0.0;
      std::uint64_t onEdges = 0;
      std::uint64_t all = 0;
      for (std::size_t pixel = 0; pixel < kWidth * kHeight; ++pixel) {
        squares += std::pow(meanOf(sums, pixel).r - image.truth(pixel), 2.0);
        const std::uint64_t added = sums.samples(pixel) - 2;  // to those that all have
        all += added;
        // Every tenth column is beside a step from 0 to 1 or has an edge.
        const auto x = pixel % kWidth % 10;
        if (x <= 2 || x >= 8) onEdges += added;
      }
      const double error = std::sqrt(squares / (kWidth * kHeight));
      EXPECT_LE(error, target) << isStratified;
      EXPECT_GE(error, target / 3.0) << isStratified;
      EXPECT_GT(static_cast<double>(onEdges) / static_cast<double>(all), 0.95);
    }
  }
}

TEST(AdaptivePlan, LeavesAPlainImageAlone) {
  AdaptivePlan plan({50, 40}, {0.01, 1024, true}, {});
  SampleSums sums(SumKind::kHalves, 50 * 40);
  const std::size_t passes = takeAll(plan, sums, [](const gpu::WorkItem& item) {
    const auto count = static_cast<float>(item.count);
    return gpu::WorkResult{glm::vec3(0.25F * count), 0.0625F * count};
  });
  EXPECT_EQ(passes, 1U);
  EXPECT_TRUE(plan.reachedTarget());
  EXPECT_LE(sums.samples(0), 4U);
  EXPECT_EQ(meanOf(sums, 7), glm::vec3(0.25F));
}

TEST(AdaptivePlan, StopsAtTheMostSamplesAllowed) {
  AdaptivePlan plan({20, 20}, {1e-4, 64, false}, {});
  SampleSums sums(SumKind::kHalves, 20 * 20);
  std::mt19937 random(3);
  takeAll(plan, sums, [&](const gpu::WorkItem& item) { return blackOrWhite(item, 0.5, random); });
  EXPECT_FALSE(plan.reachedTarget());
  EXPECT_EQ(sums.maxSamples(), 64U);
}

}  // namespace
}  // namespace lavaray
