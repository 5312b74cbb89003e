#pragma once

#include <array>

namespace lavaray {

// The rate at which the squared error of a pixel's mean converges with the number n of its samples, a power
// of two: like n^-rate. It is 1 for independent samples, 3/2 for stratified ones where an edge crosses the
// pixel (Mitchell, "Consequences of Stratified Sampling in Graphics", 1996) and 3 where all is smooth (Owen,
// "Scrambled Net Variance for Integrals of Smooth Functions", 1997).
namespace convergence {

constexpr int kRateSteps = 9;     // from 1 to 3 in steps of a quarter
constexpr int kSampleSteps = 24;  // n is 2 to the power of a sample step

constexpr double rateAt(int rateStep) {
  return 1.0 + 0.25 * rateStep;
}
constexpr int rateStepOf(double rate) {
  return static_cast<int>((rate - 1.0) * 4.0 + 0.5);
}

// The squared error of the mean of 2^sampleStep samples, in units of their unbiased sample variance.
float squaredError(int rateStep, int sampleStep);

// The expected square of half the difference of the means of the samples' first and second half, in units of
// their sample variance times n^(-3/2); for fractional sample steps, too. It decreases as the
// rate grows.
float squaredDifference(int rateStep, float sampleStep);

}  // namespace convergence
}  // namespace lavaray
