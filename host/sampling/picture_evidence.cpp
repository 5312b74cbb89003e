#include "sampling/picture_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace lavaray {
namespace {

// By how much a doubling multiplies the squared error, where little is known: nearly 2^-1.4, a little slower
// than at edges; and to how many pixels of the picture that is equal. The same number of pixels keep the
// errors of their classes.
constexpr double kUsualFall = 0.38;
constexpr double kUsualPixels = 32.0;
constexpr double kLeastFall = 0.1;
constexpr double kMostFall = 0.5;  // of independent samples

// Up to this rate a class's own is not trusted: it is of few samples, whose differences and variance are not
// far from each other.
constexpr int kRoughRateStep = convergence::rateStepOf(2.0);

// By rate step, what a doubling multiplies the squared error by. A table, as every pixel of each pass asks.
const std::array<double, convergence::kRateSteps> kFallAtRate = [] {
  std::array<double, convergence::kRateSteps> falls{};
  for (int step = 0; step < convergence::kRateSteps; ++step)
    falls[static_cast<std::size_t>(step)] = std::exp2(-convergence::rateAt(step));
  return falls;
}();

double total(const Discoveries::Sums& sums) {
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace

void PictureEvidence::add(PixelClass pixel, double squaredDifference, double formerDifference) {
  if (pixel.isSuspected()) return;
  const auto step = static_cast<std::size_t>(pixel.sampleStep());
  const double error = pixel.squaredError();
  errors_[step] += error;
  errorSquares_[step] += error * error;
  if (formerDifference > 0.0) {
    present_[step] += squaredDifference;
    former_[step] += formerDifference;
    formerSquares_ += formerDifference * formerDifference;
  } else if (pixel.rateStep() > kRoughRateStep) {
    const double ownFall = kFallAtRate[static_cast<std::size_t>(pixel.rateStep())];
    leftOfSmooth_[step] += squaredDifference * ownFall / (1.0 - ownFall);
  } else {
    single_[step] += squaredDifference;
  }
}

void PictureEvidence::add(const PictureEvidence& other) {
  const auto addTo = [](Sums& sums, const Sums& others) {
    std::transform(sums.begin(), sums.end(), others.begin(), sums.begin(), std::plus<>());
  };
  addTo(errors_, other.errors_);
  addTo(errorSquares_, other.errorSquares_);
  addTo(single_, other.single_);
  addTo(leftOfSmooth_, other.leftOfSmooth_);
  addTo(present_, other.present_);
  addTo(former_, other.former_);
  formerSquares_ += other.formerSquares_;
}

double PictureEvidence::fall() const {
  const double former = total(former_);
  if (former == 0.0) return kUsualFall;
  const double usual = kUsualPixels * formerSquares_ / former;
  return std::clamp((total(present_) + usual * kUsualFall) / (former + usual), kLeastFall, kMostFall);
}

// What is left after a difference d is d f + d f^2 + ... for a fall f; after the two differences d / f and d
// it is the same, and the two together have less chance in them.
Discoveries::Sums PictureEvidence::scales() const {
  const double one = fall();
  const double two = one * one;
  Sums scales{};
  scales.fill(1.0);
  for (std::size_t step = 1; step < scales.size(); ++step) {
    if (errors_[step] == 0.0) continue;
    const double left = leftOfSmooth_[step] + single_[step] * one / (1.0 - one) +
                        (present_[step] + former_[step]) * two / (1.0 - two);
    const double usual = kUsualPixels * errorSquares_[step] / errors_[step];
    scales[step] = (left + usual) / (errors_[step] + usual);
  }
  return scales;
}

}  // namespace lavaray
