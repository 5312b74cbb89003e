#include "image/flip_filters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace lavaray {
namespace {

using std::numbers::pi;
using Weights = std::vector<double>;

// A term of a contrast sensitivity function, transformed from frequency to space: at d degrees its weight is
// scale sqrt(pi / spread) exp(-pi^2 d^2 / spread). The numbers are the paper's.
struct SensitivityTerm {
  double scale;
  double spread;
};
constexpr SensitivityTerm kAchromatic{1.0, 0.0047};
constexpr SensitivityTerm kRedGreen{1.0, 0.0053};
constexpr SensitivityTerm kBlueYellowWide{34.1, 0.04};
constexpr SensitivityTerm kBlueYellowNarrow{13.5, 0.025};

// Width of the features that the eye detects, in degrees.
constexpr double kFeatureWidth = 0.082;

template <typename Function>
Weights sample(int radius, const Function& function) {
  Weights weights;
  for (int i = -radius; i <= radius; ++i) weights.push_back(function(static_cast<double>(i)));
  return weights;
}

double sum(const Weights& weights) {
  return std::accumulate(weights.begin(), weights.end(), 0.0);
}

Kernel scaled(const Weights& weights, double factor) {
  Kernel kernel;
  for (const double weight : weights) kernel.push_back(static_cast<float>(factor * weight));
  return kernel;
}

// Divides the positive weights by their sum and the negative ones by theirs.
Kernel balanced(const Weights& weights) {
  double positive = 0.0;
  double negative = 0.0;
  for (const double weight : weights) (weight > 0.0 ? positive : negative) += std::abs(weight);
  Kernel kernel;
  for (const double weight : weights) {
    kernel.push_back(static_cast<float>(weight / (weight > 0.0 ? positive : negative)));
  }
  return kernel;
}

Weights sensitivity(const SensitivityTerm& term, int radius, double pixelsPerDegree) {
  return sample(radius, [&](double pixels) {
    const double degrees = pixels / pixelsPerDegree;
    return std::exp(-pi * pi * degrees * degrees / term.spread);
  });
}

// The total weight of all pixels.
double mass(const SensitivityTerm& term, const Weights& weights) {
  return term.scale * std::sqrt(pi / term.spread) * sum(weights) * sum(weights);
}

// The product of the weights with themselves, scaled so that it adds up to `share`.
SeparableKernel product(const Weights& weights, double share) {
  return {scaled(weights, 1.0 / sum(weights)), scaled(weights, share / sum(weights))};
}

}  // namespace

FlipFilters flipFilters(double pixelsPerDegree) {
  FlipFilters filters;
  // Three standard deviations of the widest term.
  const int blurRadius = static_cast<int>(
      std::ceil(3.0 * std::sqrt(kBlueYellowWide.spread / (2.0 * pi * pi)) * pixelsPerDegree));
  const auto weights = [&](const SensitivityTerm& term) {
    return sensitivity(term, blurRadius, pixelsPerDegree);
  };
  filters.achromatic = product(weights(kAchromatic), 1.0);
  filters.redGreen = product(weights(kRedGreen), 1.0);
  const double wide = mass(kBlueYellowWide, weights(kBlueYellowWide));
  const double narrow = mass(kBlueYellowNarrow, weights(kBlueYellowNarrow));
  filters.blueYellowWide = product(weights(kBlueYellowWide), wide / (wide + narrow));
  filters.blueYellowNarrow = product(weights(kBlueYellowNarrow), narrow / (wide + narrow));

  const double deviation = 0.5 * kFeatureWidth * pixelsPerDegree;
  const int featureRadius = static_cast<int>(std::ceil(3.0 * deviation));
  const auto gaussian = [&](double x) { return std::exp(-x * x / (2.0 * deviation * deviation)); };
  filters.edge = balanced(sample(featureRadius, [&](double x) { return -x * gaussian(x); }));
  filters.point = balanced(
      sample(featureRadius, [&](double x) { return (x * x / (deviation * deviation) - 1.0) * gaussian(x); }));
  const Weights smooth = sample(featureRadius, gaussian);
  filters.smooth = scaled(smooth, 1.0 / sum(smooth));
  filters.maxRadius = std::max(blurRadius, featureRadius);
  return filters;
}

}  // namespace lavaray
