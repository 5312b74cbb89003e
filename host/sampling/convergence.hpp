#pragma once

#include <array>

namespace lavaray {

// How the squared error of a pixel's mean falls with the number n of its samples, which is a power of two:
// like n^-fall. Independent samples have a fall of 1, stratified ones 3/2 where an edge crosses the pixel
// (Mitchell, "Consequences of Stratified Sampling in Graphics", 1996) and 3 where all is smooth (Owen,
// "Scrambled Net Variance for Integrals of Smooth Functions", 1997).
namespace convergence {

constexpr int kFallSteps = 9;     // from 1 to 3 in steps of a quarter
constexpr int kSampleSteps = 24;  // n is 2 to the power of a sample step

constexpr double fallAt(int fallStep) {
  return 1.0 + 0.25 * fallStep;
}
constexpr int fallStepOf(double fall) {
  return static_cast<int>((fall - 1.0) * 4.0 + 0.5);
}

// The squared error of the mean of 2^sampleStep samples, in units of their unbiased sample variance.
float squaredError(int fallStep, int sampleStep);

// The expected square of half the difference of the means of the samples' first and second half, in units of
// their sample variance times n^(-3/2); for fractional sample steps, too. The higher the fall, the less it
// is.
float squaredDifference(int fallStep, float sampleStep);

}  // namespace convergence
}  // namespace lavaray
