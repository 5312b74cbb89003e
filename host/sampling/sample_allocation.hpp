#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sampling/convergence.hpp"

namespace lavaray {

// All that an allocation knows of a pixel: the squared error of its mean, the rate at which it converges,
// and how many samples it has. Quantised to 16 bits, so that allocating for a million pixels means allocating
// for a thousand classes. In place of an error that the samples show there may be one of something that is
// suspected to be there (see Discoveries).
class PixelClass {
 public:
  static constexpr std::size_t kCount =
      std::size_t{256} * (convergence::kRateSteps + 1) * convergence::kSampleSteps;

  PixelClass() = default;
  // squaredError >= 0, kept to within 13 %; what is below 2^-60 becomes 0.
  PixelClass(float squaredError, int rateStep, int sampleStep);
  static PixelClass ofSuspected(float squaredError, int sampleStep) {
    return {squaredError, convergence::kRateSteps, sampleStep};
  }
  explicit PixelClass(std::size_t index) : index_(static_cast<std::uint16_t>(index)) {}

  [[nodiscard]] std::size_t index() const { return index_; }  // < kCount
  [[nodiscard]] double squaredError() const;
  [[nodiscard]] bool isSuspected() const { return code() == convergence::kRateSteps; }
  [[nodiscard]] int rateStep() const { return isSuspected() ? kSuspectedRateStep : code(); }
  [[nodiscard]] int sampleStep() const { return index_ % convergence::kSampleSteps; }

 private:
  // Something that n samples have missed is smaller the more they are.
  static constexpr int kSuspectedRateStep = convergence::rateStepOf(2.0);
  [[nodiscard]] int code() const {
    return index_ / convergence::kSampleSteps % (convergence::kRateSteps + 1);
  }

  std::uint16_t index_ = 0;
};

struct PictureScale;

// How many samples each pixel gets so that the image's mean squared error reaches a goal with the fewest
// samples in all.
class SampleAllocation {
 public:
  // No pixel gets more than 2^maxSampleStep samples, unless it has more already.
  SampleAllocation(std::span<const PixelClass> pixels, const PictureScale& scale, double goal,
                   int maxSampleStep);

  // Of the image as it is. Where it is not above the goal, no pixel grows.
  [[nodiscard]] double squaredError() const { return squaredError_; }
  // log2 of the factor by which the samples of a pixel grow.
  [[nodiscard]] int growth(PixelClass pixel) const { return growth_[pixel.index()]; }
  [[nodiscard]] double samples() const { return samples_; }  // of all pixels, once all have grown

 private:
  // A class with what decides, at a given price per sample, how far it grows.
  struct Offer {
    PixelClass pixel;
    double pixels;
    double squaredError;
    double doublingGain;  // log2 of by how much each sample of the first doubling lowers the squared error
  };
  [[nodiscard]] static int growthAt(const Offer& offer, double logPrice, int maxSampleStep);

  double squaredError_ = 0.0;
  double samples_ = 0.0;
  std::vector<std::uint8_t> growth_;
};

}  // namespace lavaray
