#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sampling/convergence.hpp"

namespace lavaray {

// What a plan goes by of a pixel: the squared error of its mean, how that falls, and how many samples it has.
// It is quantised to a number of 16 bits, so that a plan for a million pixels is one for a thousand classes.
class PixelClass {
 public:
  static constexpr std::size_t kCount =
      std::size_t{256} * convergence::kFallSteps * convergence::kSampleSteps;

  PixelClass() = default;
  // squaredError >= 0, kept within 13 %; below 2^-60 it is none at all.
  PixelClass(float squaredError, int fallStep, int sampleStep);
  explicit PixelClass(std::size_t index) : index_(static_cast<std::uint16_t>(index)) {}

  [[nodiscard]] std::size_t index() const { return index_; }  // < kCount
  [[nodiscard]] double squaredError() const;
  [[nodiscard]] int fallStep() const { return index_ / convergence::kSampleSteps % convergence::kFallSteps; }
  [[nodiscard]] int sampleStep() const { return index_ % convergence::kSampleSteps; }

 private:
  std::uint16_t index_ = 0;
};

// How many samples the pixels shall have so that an image's mean squared error is a goal, with the fewest
// samples.
class SamplePlan {
 public:
  // No pixel gets more than 2^maxSampleStep samples, or than it has already.
  SamplePlan(std::span<const PixelClass> pixels, double goal, int maxSampleStep);

  // As the image is. Where it is not above the goal the plan is to do nothing.
  [[nodiscard]] double squaredError() const { return squaredError_; }
  // log2 of the number of times by which the samples of a pixel shall grow.
  [[nodiscard]] int growth(PixelClass pixel) const { return growth_[pixel.index()]; }
  [[nodiscard]] double samples() const { return samples_; }  // of all pixels, once all have grown

 private:
  // A class with what a price decides about it.
  struct Offer {
    PixelClass pixel;
    double pixels;
    double squaredError;
    double doublingGain;  // log2 of what the first doubling lowers it by, for each sample
  };
  [[nodiscard]] static int growthAt(const Offer& offer, double logPrice, int maxSampleStep);

  double squaredError_ = 0.0;
  double samples_ = 0.0;
  std::vector<std::uint8_t> growth_;
};

}  // namespace lavaray
