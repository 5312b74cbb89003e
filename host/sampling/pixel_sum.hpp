#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace lavaray {

// The sum of a pixel's samples in fixed point. It adds up without rounding, so the mean does not depend on
// the order in which samples arrive, nor on how they are grouped. The rounding of a single sample, 2^-41, is
// far below what a float32 image shows, and there is room for 2^22 samples.
class PixelSum {
 public:
  // Rounds to nearest, halves away from 0, as std::llround would, but without a function call for each of
  // millions of values. A float's 24 bits leave room for the half that is added.
  static std::int64_t toFixedPoint(float value) {
    const double scaled = static_cast<double>(value) * kOne;
    return static_cast<std::int64_t>(scaled + (scaled < 0.0 ? -0.5 : 0.5));
  }
  static double toDouble(std::int64_t value) { return static_cast<double>(value) * (1.0 / kOne); }

  void add(const glm::vec3& sum, std::uint32_t samples) {
    for (int channel = 0; channel < 3; ++channel) sum_[channel] += toFixedPoint(sum[channel]);
    samples_ += samples;
  }
  void add(const PixelSum& other) {
    for (int channel = 0; channel < 3; ++channel) sum_[channel] += other.sum_[channel];
    samples_ += other.samples_;
  }
  [[nodiscard]] std::uint32_t samples() const { return samples_; }
  // Black where there are no samples.
  [[nodiscard]] glm::dvec3 mean() const {
    if (samples_ == 0) return glm::dvec3(0.0);
    const glm::dvec3 sum(toDouble(sum_[0]), toDouble(sum_[1]), toDouble(sum_[2]));
    return sum / static_cast<double>(samples_);
  }

 private:
  static constexpr double kOne = 0x1p40;
  std::int64_t sum_[3] = {0, 0, 0};
  std::uint32_t samples_ = 0;
  std::uint32_t padding_ = 0;  // films hold these bytes, so none may be left to chance
};

// The sums of the first and of the second half of a pixel's samples, whose number is a power of two. If there
// are only two, both are in the first half.
struct HalfSums {
  PixelSum halves[2];
  // The squared colour, averaged over the channels and summed over the samples, in the same fixed point.
  std::int64_t squares = 0;
  // Of when the samples were half as many: half the difference of the halves' means, squared; 0 where there
  // were fewer than two, or where something was suspected that they had missed: that, until the next
  // estimate.
  float formerDifference = 0.0F;
  float suspected = 0.0F;
};

}  // namespace lavaray
