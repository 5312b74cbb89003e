#include "sampling/error_estimate.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/parallel.hpp"
#include "sampling/convergence.hpp"
#include "sampling/picture_evidence.hpp"

namespace lavaray {
namespace {

using convergence::rateStepOf;

// Where nothing is known: a little slower than at edges, since overshooting the target is worse than
// undershooting it.
constexpr int kUsualRateStep = rateStepOf(1.25);
constexpr int kIndependentRateStep = rateStepOf(1.0);
constexpr int kSmoothRateStep = rateStepOf(3.0);
// The usual rate counts as much as this many pixels in which another one is observed.
constexpr float kUsualRatePixels = 2.0F;

// Pixels to each side of a pixel that tell the rate there.
constexpr int kReach = 2;
// On a straight slope of shading the squared contrast between two neighbours is at most this many times the
// variance within one: 12 across the pixels' sides, and as much again for chance.
constexpr float kSlopeContrast = 24.0F;
// Where shading is smooth, the variance of two samples is 1/7 of its squared slope. Below the first of these
// shares it counts as smooth, above the second as not; what lies between may be chance.
constexpr float kSmoothShare = 0.35F;
constexpr float kRoughShare = 0.7F;
// What is suspected is taken for the error of a pixel where this share of it is more than what the samples
// show.
constexpr float kSuspectedShare = 0.05F;
// What neighbours show is of no interest if squared it is less than this, about a level of 8 bits.
constexpr float kMinAmplitude = 1e-5F;
// Among n samples that have met it, a value that differs by a from all others has a variance of at least a^2
// / n.
constexpr float kMissedVariance = 0.5F;

template <typename Vector>
auto meanSquare(const Vector& v) {
  return (v.r * v.r + v.g * v.g + v.b * v.b) / 3;
}

// What a neighbour shows may be in the pixel, too, beyond all its samples. If it covers a share c of the
// pixel, every c being equally likely, and n samples have missed it, the mean of c^2 is 2 / ((n + 2) (n +
// 3)). In how many pixels it is there at all is for Discoveries to tell.
float suspectedError(float squaredAmplitude, float samples) {
  return std::max(squaredAmplitude, 0.0F) * 2.0F / ((samples + 2.0F) * (samples + 3.0F));
}

// If a neighbour's samples have two values, one of them the pixel's own, their squared difference: with the
// other one's probability q, the contrast is its q-th part and the variance has q (1 - q) of its square.
// Where the contrast is a small part of the variance, as between pixels of one penumbra, q is not known so
// well.
float squaredAmplitude(float squaredContrast, float neighbourVariance) {
  const float sum = squaredContrast + neighbourVariance;
  return sum * std::min(sum / std::max(squaredContrast, 1e-12F), 4.0F);
}

// How much a neighbour's variance says about a pixel's own, of which n samples are known. In a penumbra where
// few samples are blocked, a pixel may have met none of them and yet be as hard as one that has: their
// contrast is small compared with the variance. Beside an edge the contrast is large. If the neighbour's
// samples have two values, one of them the pixel's own, q is the probability of the other one, and (1 - q)^n
// is the chance that a pixel of the same kind has met none. It is squared, since the variance is itself a
// guess, and computed as (1 - n q / 4)^8, which is nearly the same and needs no exponential function.
float likeness(float squaredContrast, float neighbourVariance, float n) {
  if (squaredContrast == 0.0F) return 1.0F;
  const float q = squaredContrast / (squaredContrast + neighbourVariance);
  const float root = std::max(0.0F, 1.0F - 0.25F * n * q);
  const float square = root * root;
  return square * square * square * square;
}

// The lesser of two slopes, 0 where one rises and the other falls.
float lesserSlope(float a, float b) {
  return a * b > 0.0F ? std::min(std::abs(a), std::abs(b)) : 0.0F;
}
glm::vec3 lesserSlope(const glm::vec3& a, const glm::vec3& b) {
  return {lesserSlope(a.r, b.r), lesserSlope(a.g, b.g), lesserSlope(a.b, b.b)};
}

}  // namespace

ErrorEstimate::ErrorEstimate(int width, int height, bool isStratified, double negligible)
    : width_(width),
      height_(height),
      isStratified_(isStratified),
      negligible_(static_cast<float>(negligible)),
      isMarked_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      statistics_(isMarked_.size()),
      classes_(isMarked_.size()) {}

void ErrorEstimate::markAll() {
  std::fill(isMarked_.begin(), isMarked_.end(), std::uint8_t{1});
}

void ErrorEstimate::update(std::span<const HalfSums> sums) {
  updateRows(sums, height_, hardwareThreads());
  std::fill(isMarked_.begin(), isMarked_.end(), std::uint8_t{0});
  statisticsEnd_ = 0;
  classesEnd_ = 0;
}

void ErrorEstimate::updateRows(std::span<const HalfSums> sums, int end) {
  updateRows(sums, end, std::max(1U, hardwareThreads() / 2));
}

void ErrorEstimate::updateRows(std::span<const HalfSums> sums, int end, unsigned threads) {
  const auto forRows = [threads](int first, int last, const auto& work) {
    parallelFor(static_cast<std::size_t>(std::max(0, last - first)), threads,
                [&](std::size_t row) { work(first + static_cast<int>(row)); });
  };
  forRows(statisticsEnd_, end, [&](int y) { updateStatistics(sums, y); });
  statisticsEnd_ = std::max(statisticsEnd_, end);
  const int classesEnd = statisticsEnd_ == height_ ? height_ : statisticsEnd_ - kReach;
  forRows(classesEnd_, classesEnd, [&](int y) { updateClasses(y); });
  classesEnd_ = std::max(classesEnd_, classesEnd);
}

void ErrorEstimate::updateStatistics(std::span<const HalfSums> sums, int y) {
  const auto columns = static_cast<std::size_t>(width_);
  const std::size_t begin = static_cast<std::size_t>(y) * columns;
  for (std::size_t pixel = begin; pixel < begin + columns; ++pixel)
    if (isMarked_[pixel] != 0) statistics_[pixel] = statistics(sums[pixel]);
}

void ErrorEstimate::updateClasses(int y) {
  const auto columns = static_cast<std::size_t>(width_);
  std::vector<std::uint8_t> marks(columns + 2 * kReach);  // of the rows around, with margins
  for (int v = std::max(0, y - kReach); v <= std::min(height_ - 1, y + kReach); ++v) {
    const std::uint8_t* row = &isMarked_[static_cast<std::size_t>(v) * columns];
    for (std::size_t x = 0; x < columns; ++x) marks[x + kReach] |= row[x];
  }
  PixelClass* classes = &classes_[static_cast<std::size_t>(y) * columns];
  for (std::size_t x = 0; x < columns; ++x) {
    static_assert(kReach == 2);
    const bool isNearMark = (marks[x] | marks[x + 1] | marks[x + 2] | marks[x + 3] | marks[x + 4]) != 0;
    if (isNearMark) classes[x] = classOf(static_cast<int>(x), y);
  }
}

ErrorEstimate::Statistics ErrorEstimate::statistics(const HalfSums& sums) {
  PixelSum all = sums.halves[0];
  all.add(sums.halves[1]);
  const glm::dvec3 mean = all.mean();
  const double n = all.samples();
  const double squares = PixelSum::toDouble(sums.squares);
  const double variance = std::max(0.0, squares - n * meanSquare(mean)) / (n - 1.0);
  // The first two samples are not kept apart; there the variance says the same.
  const double difference =
      n > 2.0 ? meanSquare((sums.halves[0].mean() - sums.halves[1].mean()) / 2.0) : variance / 2.0;
  return {glm::vec3(mean), static_cast<float>(variance), static_cast<float>(difference * n * std::sqrt(n)),
          static_cast<int>(std::bit_width(all.samples())) - 1};
}

// The convergence rate where nothing is known except that few samples have this variance. If a straight
// slope explains the variance, the shading is smooth.
int ErrorEstimate::usualRateStep(int x, int y, float variance) const {
  if (x == 0 || y == 0 || x == width_ - 1 || y == height_ - 1) return kUsualRateStep;
  const Statistics* own = &statistics_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + x];
  const auto slope = [own](int step) {
    return meanSquare(lesserSlope(own->mean - own[-step].mean, own[step].mean - own->mean));
  };
  const float squaredSlope = slope(1) + slope(width_);
  const float share = (kRoughShare * squaredSlope - variance) / ((kRoughShare - kSmoothShare) * squaredSlope);
  if (!(share > 0.0F)) return kUsualRateStep;
  constexpr auto kSteps = static_cast<float>(kSmoothRateStep - kUsualRateStep);
  return kUsualRateStep + static_cast<int>(std::min(share, 1.0F) * kSteps + 0.5F);
}

int ErrorEstimate::rateStepAround(int x, int y, int usualRateStep) const {
  float differences = 0.0F;
  float variances = 0.0F;
  float squaredVariances = 0.0F;
  float steps = 0.0F;
  for (int v = std::max(0, y - kReach); v <= std::min(height_ - 1, y + kReach); ++v) {
    for (int u = std::max(0, x - kReach); u <= std::min(width_ - 1, x + kReach); ++u) {
      const Statistics& s = statistics_[static_cast<std::size_t>(v) * width_ + u];
      differences += s.difference;
      variances += s.variance;
      squaredVariances += s.variance * s.variance;
      steps += s.variance * static_cast<float>(s.sampleStep);
    }
  }
  // Two samples' difference is their variance.
  const float step = steps / variances;
  if (!(step >= 1.25F)) return usualRateStep;
  // As if a few more pixels of the usual rate had been observed; pixels without variance do not count.
  const float count = variances * variances / squaredVariances;
  const float usual = convergence::squaredDifference(usualRateStep, step);
  const float met = (count * differences / variances + kUsualRatePixels * usual) / (count + kUsualRatePixels);
  int rateStep = 0;
  while (rateStep < kSmoothRateStep &&
         convergence::squaredDifference(rateStep, step) + convergence::squaredDifference(rateStep + 1, step) >
             2.0F * met) {
    ++rateStep;
  }
  return rateStep;
}

float ErrorEstimate::squaredDifference(std::size_t pixel) const {
  const Statistics& s = statistics_[pixel];
  const auto n = static_cast<float>(1U << static_cast<unsigned>(s.sampleStep));
  return s.difference / (n * std::sqrt(n));
}

PictureScale ErrorEstimate::scale(std::span<const HalfSums> sums, const Discoveries& discoveries) const {
  PictureScale result{{}, discoveries.shares()};
  result.seen.fill(1.0);
  if (!isStratified_) return result;  // the variance tells the error of independent samples
  const auto columns = static_cast<std::size_t>(width_);
  std::vector<PictureEvidence> rows(static_cast<std::size_t>(height_));
  parallelFor(rows.size(), hardwareThreads(), [&](std::size_t y) {
    for (std::size_t pixel = y * columns; pixel < (y + 1) * columns; ++pixel)
      rows[y].add(classes_[pixel], double{squaredDifference(pixel)}, double{sums[pixel].formerDifference});
  });
  PictureEvidence all;
  for (const PictureEvidence& row : rows) all.add(row);
  result.seen = all.scales();
  return result;
}

PixelClass ErrorEstimate::classOf(int x, int y) const {
  const Statistics& own = statistics_[static_cast<std::size_t>(y) * width_ + x];
  const auto n = static_cast<float>(1U << static_cast<unsigned>(own.sampleStep));
  float variance = 0.0F;
  float weights = 0.0F;
  float amplitude = 0.0F;  // squared, of what neighbours show
  for (int v = std::max(0, y - 1); v <= std::min(height_ - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(width_ - 1, x + 1); ++u) {
      const Statistics& neighbour = statistics_[static_cast<std::size_t>(v) * width_ + u];
      const float contrast = meanSquare(neighbour.mean - own.mean);
      const float weight = likeness(contrast, neighbour.variance, n);
      variance += weight * neighbour.variance;
      weights += weight;
      amplitude = std::max(amplitude, squaredAmplitude(contrast, neighbour.variance));
    }
  }
  variance /= weights;
  int rateStep = isStratified_ ? kUsualRateStep : kIndependentRateStep;
  if (isStratified_ && variance * convergence::squaredError(rateStep, own.sampleStep) > negligible_)
    rateStep = rateStepAround(x, y, usualRateStep(x, y, variance));
  const float seen = variance * convergence::squaredError(rateStep, own.sampleStep);
  const bool mayMiss = amplitude > kMinAmplitude && own.variance < kMissedVariance * amplitude / n;
  const float suspected = mayMiss ? suspectedError(amplitude - kSlopeContrast * variance, n) : 0.0F;
  return seen >= kSuspectedShare * suspected ? PixelClass(seen, rateStep, own.sampleStep)
                                             : PixelClass::ofSuspected(suspected, own.sampleStep);
}

}  // namespace lavaray
