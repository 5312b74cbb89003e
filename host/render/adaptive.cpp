#include "render/adaptive.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/parallel.hpp"

namespace lavaray {
namespace {

// The error of a mean of n samples is taken to be hardness^(1/2) n^(-3/4), its square hardness n^(-3/2).
constexpr double kVarianceExponent = 1.5;
// Step 1 is a hardness of 2^-50, beyond which nothing shows.
constexpr double kLowestHardnessLog2 = -50.0;
constexpr double kStepsPerDoubling = 4.0;
constexpr int kHardnessSteps = 256;
constexpr int kSampleSteps = 24;
// In one pass a pixel's samples grow at most by this factor, as the first estimates are rough; log2.
constexpr int kLargestGrowthLog2 = 2;
// All samples of a render over those it begins with, as long as nothing is known of the image; for the
// progress.
constexpr double kUsualGrowth = 4.0;
// Samples of each half to begin with.
constexpr std::uint32_t kFirstHalfSamples = 1;

// The same where an object falls that so few can miss; the lower the target, the more a missed one matters.
std::uint32_t smallObjectHalfSamples(double targetError) {
  return std::bit_floor(static_cast<std::uint32_t>(std::clamp(0.04 / targetError, 1.0, 32.0)));
}

// Aims lower than asked for: pixels that look too easy by chance are not looked at again, which makes the
// estimate a little too low.
constexpr double kGoalFactor = 0.9;
// Of the pixels that differ from a neighbour, how many have an edge that was missed. Measured: higher and the
// target is undercut for nothing, lower and it is passed.
constexpr double kUnseenShare = 0.1;

double hardnessOf(int step) {
  return std::exp2(kLowestHardnessLog2 + (step - 1) / kStepsPerDoubling);
}

// n^kVarianceExponent, without a call of std::pow for each pixel in each pass.
double hardnessFactor(double n) {
  static_assert(kVarianceExponent == 1.5);
  return n * std::sqrt(n);
}

double varianceFactor(int sampleStep) {
  return std::exp2(-kVarianceExponent * sampleStep);
}

std::uint8_t hardnessStep(double hardness) {
  if (!(hardness > 0.0)) return 0;
  const double step = 1.5 + kStepsPerDoubling * (std::log2(hardness) - kLowestHardnessLog2);
  return static_cast<std::uint8_t>(std::clamp(step, 0.0, kHardnessSteps - 1.0));
}

template <typename Vector>
auto meanSquare(const Vector& v) {
  return (v.r * v.r + v.g * v.g + v.b * v.b) / 3;
}

int sampleStepOf(std::uint32_t samples) {
  return static_cast<int>(std::bit_width(samples)) - 1;
}

// What the samples of two halves gain by stratification at an edge, in units of hardness over variance;
// measured.
constexpr double kUsualStratification = 0.9;
// Pixels to each side of a pixel that say what is gained there.
constexpr int kStratificationReach = 2;
// On a slope of shading that runs straight through pixels, two neighbours' squared contrast is at most so
// many times the variance within one: 12 across the pixels' sides, and as much again for what chance does.
constexpr double kSlopeContrast = 24.0;

// Where two pixels differ there may be an edge that happens to lie beyond all samples of either. Of an edge
// that covers a share c of the pixel, all c alike, and that n samples have missed, c^2 is 2 / ((n + 2) (n +
// 3)) in the mean.
double unseenEdge(double squaredContrast, double samples) {
  return kUnseenShare * squaredContrast * 2.0 / ((samples + 2.0) * (samples + 3.0));
}

// How much a neighbour's variance says of a pixel's own, of which n samples are known. In a penumbra where
// few samples are blocked a pixel may have met none and be as hard as one that has: their contrast is small
// against the variance. Beside an edge the contrast is large. If the neighbour's samples have two values, one
// of them the pixel's own, they have the other one with this probability q, and (1 - q)^n is the chance that
// the pixel has met none though it is alike; taken twice, as the variance is itself a guess.
double likeness(double squaredContrast, double neighbourVariance, double n) {
  if (squaredContrast == 0.0) return 1.0;
  if (neighbourVariance == 0.0) return 0.0;
  const double q = squaredContrast / (squaredContrast + neighbourVariance);
  return std::exp(-2.0 * n * q);
}

}  // namespace

AdaptiveSampling::AdaptiveSampling(int width, int height, double targetError, std::uint32_t maxSamples,
                                   std::vector<std::uint64_t> smallObjects)
    : width_(width),
      height_(height),
      goal_(kGoalFactor * targetError),
      maxSampleStep_(std::min(sampleStepOf(maxSamples), kSampleSteps - 1)),
      smallObjectHalfSamples_(std::min(smallObjectHalfSamples(targetError), largestHalfCount())),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      smallObjects_(std::move(smallObjects)),
      hardnessSteps_(pixels_.size()) {}

glm::dvec3 AdaptiveSampling::mean(std::uint64_t pixel) const {
  PixelSum sum = pixels_[pixel].halves[0];
  sum.add(pixels_[pixel].halves[1]);
  return sum.mean();
}

std::uint32_t AdaptiveSampling::samples(std::uint64_t pixel) const {
  return pixels_[pixel].halves[0].samples() + pixels_[pixel].halves[1].samples();
}

double AdaptiveSampling::estimatedError(std::uint64_t pixel) const {
  const int step = hardnessSteps_[pixel];
  if (step == 0 || samples(pixel) == 0) return 0.0;
  return std::sqrt(hardnessOf(step) * varianceFactor(sampleStepOf(samples(pixel))));
}

void AdaptiveSampling::add(const gpu::WorkItem& item, const gpu::WorkResult& result) {
  pixels_[item.pixel].halves[item.sequence].add(result.sum, item.count);
  pixels_[item.pixel].squares += PixelSum::toFixedPoint(result.squares);
}

void AdaptiveSampling::goOnWith(std::vector<HalfSums> pixels) {
  assert(pixels.size() == pixels_.size());
  pixels_ = std::move(pixels);
  hasStarted_ = true;
  for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel)
    plannedSamples_ += kUsualGrowth * samples(pixel);
}

// Items end at powers of two up to the largest size and at multiples of it, wherever a pass ends: so samples
// are always summed in the same groups, and the image does not depend on the passes that took them.
void AdaptiveSampling::appendSamples(std::vector<gpu::WorkItem>& items, std::size_t pixel,
                                     std::uint32_t halfCount) const {
  for (gpu::uint half = 0; half < 2; ++half) {
    for (std::uint32_t first = pixels_[pixel].halves[half].samples(); first < halfCount;) {
      const std::uint32_t count = std::clamp(first, 1U, gpu::kMaxSamplesPerItem);
      items.push_back({static_cast<gpu::uint>(pixel), half, first, count});
      first += count;
    }
  }
}

void AdaptiveSampling::appendFirstSamples(std::vector<gpu::WorkItem>& items) const {
  std::vector<std::uint32_t> halfCounts(pixels_.size(), kFirstHalfSamples);
  for (const std::uint64_t pixel : smallObjects_) halfCounts[pixel] = smallObjectHalfSamples_;
  items.reserve(2 * pixels_.size());
  for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel) appendSamples(items, pixel, halfCounts[pixel]);
}

std::vector<gpu::WorkItem> AdaptiveSampling::nextItems() {
  std::vector<gpu::WorkItem> items;
  if (!hasStarted_) {
    hasStarted_ = true;
    appendFirstSamples(items);
    for (const gpu::WorkItem& item : items) plannedSamples_ += kUsualGrowth * item.count;
    return items;
  }
  estimateHardness();
  const std::vector<Class> all = classes();
  // At an infinite price nothing more is bought: what is left is the error as it is.
  estimatedError_ = std::sqrt(plannedVariance(all, INFINITY));
  if (reachedTarget()) return items;
  const double price = choosePrice(all);
  plannedSamples_ = 0.0;
  for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel) {
    const int now = sampleStepOf(samples(pixel));
    const int planned = plannedStep(hardnessSteps_[pixel], now, price);
    plannedSamples_ += std::exp2(planned);
    const int step = std::min(planned, now + kLargestGrowthLog2);
    appendSamples(items, pixel, (1U << static_cast<unsigned>(step)) / 2);
  }
  return items;
}

AdaptiveSampling::Statistics AdaptiveSampling::statistics(std::size_t pixel) const {
  const auto& halves = pixels_[pixel].halves;
  const double n = samples(pixel);
  const glm::dvec3 pixelMean = mean(pixel);
  const double difference = meanSquare((halves[0].mean() - halves[1].mean()) / 2.0);
  const double variance =
      std::max(0.0, PixelSum::toDouble(pixels_[pixel].squares) - n * meanSquare(pixelMean)) / (n - 1.0);
  return {glm::vec3(pixelMean), static_cast<float>(difference * hardnessFactor(n)),
          static_cast<float>(variance)};
}

double AdaptiveSampling::stratification(int x, int y, const std::vector<Statistics>& all) const {
  double differences = 0.0;
  double variances = 0.0;
  double count = 0.0;
  for (int v = std::max(0, y - kStratificationReach); v <= std::min(height_ - 1, y + kStratificationReach);
       ++v) {
    for (int u = std::max(0, x - kStratificationReach); u <= std::min(width_ - 1, x + kStratificationReach);
         ++u) {
      const Statistics& s = all[static_cast<std::size_t>(v) * width_ + u];
      differences += double{s.difference};
      variances += double{s.variance};
      ++count;
    }
  }
  // As if one more pixel had been met, with the usual gain: halves that are equal by chance are not free of
  // error.
  return variances > 0.0 ? (count * differences / variances + kUsualStratification) / (count + 1.0) : 0.0;
}

double AdaptiveSampling::hardness(int x, int y, const std::vector<Statistics>& all) const {
  const std::size_t pixel = static_cast<std::size_t>(y) * width_ + x;
  const Statistics& own = all[pixel];
  const double n = samples(pixel);
  double variance = 0.0;
  double weights = 0.0;
  double largestContrast = 0.0;
  for (int v = std::max(0, y - 1); v <= std::min(height_ - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(width_ - 1, x + 1); ++u) {
      const Statistics& neighbour = all[static_cast<std::size_t>(v) * width_ + u];
      const double contrast = double{meanSquare(neighbour.mean - own.mean)};
      const double weight = likeness(contrast, double{neighbour.variance}, n);
      variance += weight * double{neighbour.variance};
      weights += weight;
      largestContrast = std::max(largestContrast, contrast);
    }
  }
  const double seen = variance > 0.0 ? stratification(x, y, all) * variance / weights : 0.0;
  const double unexplained = std::max(0.0, largestContrast - kSlopeContrast * double{own.variance});
  return std::max(seen, unseenEdge(unexplained, n) * hardnessFactor(n));
}

void AdaptiveSampling::estimateHardness() {
  std::vector<Statistics> all(pixels_.size());
  const auto rows = static_cast<std::size_t>(height_);
  const auto columns = static_cast<std::size_t>(width_);
  parallelFor(rows, hardwareThreads(), [&](std::size_t y) {
    for (std::size_t pixel = y * columns; pixel < (y + 1) * columns; ++pixel) all[pixel] = statistics(pixel);
  });
  parallelFor(rows, hardwareThreads(), [&](std::size_t y) {
    for (std::size_t x = 0; x < columns; ++x) {
      hardnessSteps_[y * columns + x] = hardnessStep(hardness(static_cast<int>(x), static_cast<int>(y), all));
    }
  });
}

std::vector<AdaptiveSampling::Class> AdaptiveSampling::classes() const {
  std::array<std::array<std::uint32_t, kSampleSteps>, kHardnessSteps> counts{};
  for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel) {
    ++counts[hardnessSteps_[pixel]][sampleStepOf(samples(pixel))];
  }
  std::vector<Class> result;
  for (int hardness = 1; hardness < kHardnessSteps; ++hardness) {
    for (int samples = 0; samples < kSampleSteps; ++samples) {
      if (counts[hardness][samples] > 0)
        result.push_back({hardness, samples, static_cast<double>(counts[hardness][samples])});
    }
  }
  return result;
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

double AdaptiveSampling::plannedVariance(const std::vector<Class>& all, double price) const {
  double sum = 0.0;
  for (const Class& c : all) {
    sum += c.pixels * hardnessOf(c.hardnessStep) *
           varianceFactor(plannedStep(c.hardnessStep, c.sampleStep, price));
  }
  return sum / static_cast<double>(pixels_.size());
}

// The highest price, and so the fewest samples, at which the plan's error is the goal. The plan is the whole
// way there: if a pass's limit on growth counted here, every pixel would be asked to make up for the hard
// ones.
double AdaptiveSampling::choosePrice(const std::vector<Class>& all) const {
  double low = -120.0;
  double high = 60.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2.0;
    const bool enough = plannedVariance(all, std::exp2(middle)) <= goal_ * goal_;
    (enough ? low : high) = middle;
  }
  return std::exp2(low);
}

}  // namespace lavaray
