#include "render/adaptive.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace lavaray {
namespace {

// The error of a mean of n samples is taken to be hardness^(1/2) n^(-3/4), its square hardness n^(-3/2).
constexpr double kVarianceExponent = 1.5;
// Step 1 is a hardness of 2^-50, beyond which nothing shows.
constexpr double kLowestHardnessLog2 = -50.0;
constexpr double kStepsPerDoubling = 4.0;
// In one pass a pixel's samples grow at most by this factor, as the first estimates are rough; log2.
constexpr int kLargestGrowthLog2 = 2;
// Samples of each half to begin with: what these miss, and all their neighbours' too, is never found, so
// there are more of them where less may be missed.
std::uint32_t firstHalfSamples(double targetError) {
  if (targetError > 0.01) return 1;
  return targetError > 0.003 ? 2 : 4;
}

// The same where an object falls that these samples can miss.
constexpr std::uint32_t kSmallObjectHalfSamples = 16;
// Aims lower than asked for: pixels that look too easy by chance are not looked at again, which makes the
// estimate a little too low.
constexpr double kGoalFactor = 0.85;
// Of the pixels that differ from a neighbour, how many have an edge that was missed. Measured: higher and the
// target is undercut for nothing, lower and it is passed.
constexpr double kUnseenShare = 0.1;

double hardnessOf(int step) {
  return std::exp2(kLowestHardnessLog2 + (step - 1) / kStepsPerDoubling);
}

double varianceFactor(int sampleStep) {
  return std::exp2(-kVarianceExponent * sampleStep);
}

std::uint8_t hardnessStep(double hardness) {
  if (!(hardness > 0.0)) return 0;
  const double step = 1.5 + kStepsPerDoubling * (std::log2(hardness) - kLowestHardnessLog2);
  return static_cast<std::uint8_t>(std::clamp(step, 0.0, 255.0));
}

double meanSquare(const glm::dvec3& v) {
  return (v.r * v.r + v.g * v.g + v.b * v.b) / 3.0;
}

int sampleStepOf(std::uint32_t samples) {
  return static_cast<int>(std::bit_width(samples)) - 1;
}

}  // namespace

AdaptiveSampling::AdaptiveSampling(int width, int height, double targetError, std::uint32_t maxSamples,
                                   std::vector<std::uint64_t> smallObjects)
    : width_(width),
      height_(height),
      goal_(kGoalFactor * targetError),
      firstHalfSamples_(std::min(firstHalfSamples(targetError), maxSamples / 2)),
      maxSampleStep_(std::min(sampleStepOf(maxSamples), kSampleSteps - 1)),
      halves_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      smallObjects_(std::move(smallObjects)),
      hardnessSteps_(halves_.size()) {}

glm::dvec3 AdaptiveSampling::mean(std::uint64_t pixel) const {
  PixelSum sum = halves_[pixel][0];
  sum.add(halves_[pixel][1]);
  return sum.mean();
}

std::uint32_t AdaptiveSampling::samples(std::uint64_t pixel) const {
  return halves_[pixel][0].samples() + halves_[pixel][1].samples();
}

double AdaptiveSampling::estimatedError(std::uint64_t pixel) const {
  const int step = hardnessSteps_[pixel];
  if (step == 0 || samples(pixel) == 0) return 0.0;
  return std::sqrt(hardnessOf(step) * varianceFactor(sampleStepOf(samples(pixel))));
}

void AdaptiveSampling::add(const gpu::WorkItem& item, const glm::vec3& sum) {
  halves_[item.pixel][item.sequence].add(sum, item.count);
}

void AdaptiveSampling::appendSamples(std::vector<gpu::WorkItem>& items, std::size_t pixel,
                                     std::uint32_t halfCount) const {
  for (gpu::uint half = 0; half < 2; ++half) {
    for (std::uint32_t first = halves_[pixel][half].samples(); first < halfCount;
         first += gpu::kMaxSamplesPerItem) {
      items.push_back(
          {static_cast<gpu::uint>(pixel), half, first, std::min(gpu::kMaxSamplesPerItem, halfCount - first)});
    }
  }
}

std::vector<gpu::WorkItem> AdaptiveSampling::nextItems() {
  std::vector<gpu::WorkItem> items;
  if (!hasStarted_) {
    hasStarted_ = true;
    std::vector<std::uint32_t> halfCounts(halves_.size(), firstHalfSamples_);
    for (const std::uint64_t pixel : smallObjects_) {
      halfCounts[pixel] = std::max(firstHalfSamples_, std::min(kSmallObjectHalfSamples, largestHalfCount()));
    }
    for (std::size_t pixel = 0; pixel < halves_.size(); ++pixel)
      appendSamples(items, pixel, halfCounts[pixel]);
    return items;
  }
  estimateHardness();
  const Histogram counts = histogram();
  // At an infinite price nothing more is bought: what is left is the error as it is.
  estimatedError_ = std::sqrt(plannedVariance(counts, INFINITY));
  if (reachedTarget()) return items;
  const double price = choosePrice(counts);
  for (std::size_t pixel = 0; pixel < halves_.size(); ++pixel) {
    const int now = sampleStepOf(samples(pixel));
    const int step = std::min(plannedStep(hardnessSteps_[pixel], now, price), now + kLargestGrowthLog2);
    appendSamples(items, pixel, (1U << static_cast<unsigned>(step)) / 2);
  }
  return items;
}

// Mean over the channels of the squared half difference of the halves' means.
double AdaptiveSampling::difference(std::size_t pixel) const {
  return meanSquare((halves_[pixel][0].mean() - halves_[pixel][1].mean()) / 2.0);
}

// Where two pixels differ there may be an edge that happens to lie beyond all samples of either. Of an edge
// that covers a share c of the pixel, all c alike, and that n samples have missed, c^2 is 2 / ((n + 2) (n +
// 3)) in the mean.
double AdaptiveSampling::unseenEdge(double squaredContrast, std::uint32_t samples) {
  const double n = samples;
  return kUnseenShare * squaredContrast * 2.0 / ((n + 2.0) * (n + 3.0));
}

void AdaptiveSampling::estimateHardness() {
  std::vector<double> own(halves_.size());
  std::vector<glm::dvec3> means(halves_.size());
  for (std::size_t pixel = 0; pixel < own.size(); ++pixel) {
    own[pixel] = difference(pixel) / varianceFactor(sampleStepOf(samples(pixel)));
    means[pixel] = mean(pixel);
  }
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * width_ + x;
      double sum = 0.0;
      int count = 0;
      double squaredContrast = 0.0;
      for (int v = std::max(0, y - 1); v <= std::min(height_ - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(width_ - 1, x + 1); ++u) {
          const std::size_t neighbour = static_cast<std::size_t>(v) * width_ + u;
          sum += own[neighbour];
          squaredContrast = std::max(squaredContrast, meanSquare(means[neighbour] - means[pixel]));
          ++count;
        }
      }
      const double unseen =
          unseenEdge(squaredContrast, samples(pixel)) / varianceFactor(sampleStepOf(samples(pixel)));
      hardnessSteps_[pixel] = hardnessStep(std::max(sum / count, unseen));
    }
  }
}

AdaptiveSampling::Histogram AdaptiveSampling::histogram() const {
  Histogram counts{};
  for (std::size_t pixel = 0; pixel < halves_.size(); ++pixel) {
    ++counts[hardnessSteps_[pixel]][sampleStepOf(samples(pixel))];
  }
  return counts;
}

// log2 of the samples that a pixel shall have, at a price of one sample in units of variance.
int AdaptiveSampling::plannedStep(int hardnessStep, int sampleStep, double price) const {
  if (hardnessStep == 0 || !std::isfinite(price)) return sampleStep;
  // Where the derivative of hardness n^(-3/2) is the price.
  const double wanted =
      std::log2(kVarianceExponent * hardnessOf(hardnessStep) / price) / (kVarianceExponent + 1.0);
  return std::clamp(static_cast<int>(std::lround(std::clamp(wanted, -1.0, 64.0))), sampleStep,
                    std::max(sampleStep, maxSampleStep_));
}

double AdaptiveSampling::plannedVariance(const Histogram& counts, double price) const {
  double sum = 0.0;
  for (int hardness = 1; hardness < kHardnessSteps; ++hardness) {
    for (int samples = 0; samples < kSampleSteps; ++samples) {
      const std::uint32_t count = counts[hardness][samples];
      if (count > 0)
        sum += count * hardnessOf(hardness) * varianceFactor(plannedStep(hardness, samples, price));
    }
  }
  return sum / static_cast<double>(halves_.size());
}

// The highest price, and so the fewest samples, at which the plan's error is the goal. The plan is the whole
// way there: if a pass's limit on growth counted here, every pixel would be asked to make up for the hard
// ones.
double AdaptiveSampling::choosePrice(const Histogram& counts) const {
  double low = -120.0;
  double high = 60.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2.0;
    const bool enough = plannedVariance(counts, std::exp2(middle)) <= goal_ * goal_;
    (enough ? low : high) = middle;
  }
  return std::exp2(low);
}

}  // namespace lavaray
