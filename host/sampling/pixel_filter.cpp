#include "sampling/pixel_filter.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace lavaray {
namespace {

constexpr int kTableSize = 257;
constexpr int kSteps = 1 << 16;  // of the integration

constexpr std::array kFilters = {PixelFilter::kBox, PixelFilter::kTent, PixelFilter::kGaussian,
                                 PixelFilter::kBlackmanHarris};

struct Shape {
  double radius;
  std::function<double(double)> weight;  // not normalised, symmetric
};

Shape shapeOf(PixelFilter filter) {
  switch (filter) {
    case PixelFilter::kTent:
      return {1.0, [](double x) { return 1.0 - std::abs(x); }};
    case PixelFilter::kGaussian:
      // Lowered so that it ends at zero.
      return {1.5, [](double x) { return std::exp(-2.0 * x * x) - std::exp(-2.0 * 1.5 * 1.5); }};
    case PixelFilter::kBlackmanHarris:
      // Harris, "On the Use of Windows for Harmonic Analysis with the Discrete Fourier Transform", 1978.
      return {1.5, [](double x) {
                const double phase = 2.0 * std::numbers::pi * (x / 3.0 + 0.5);
                return 0.35875 - 0.48829 * std::cos(phase) + 0.14128 * std::cos(2.0 * phase) -
                       0.01168 * std::cos(3.0 * phase);
              }};
    case PixelFilter::kBox:
      break;
  }
  return {0.5, [](double) { return 1.0; }};
}

}  // namespace

std::optional<PixelFilter> pixelFilter(const std::string& name) {
  for (const PixelFilter filter : kFilters) {
    if (name == pixelFilterName(filter)) return filter;
  }
  return std::nullopt;
}

std::string pixelFilterName(PixelFilter filter) {
  switch (filter) {
    case PixelFilter::kTent:
      return "tent";
    case PixelFilter::kGaussian:
      return "gaussian";
    case PixelFilter::kBlackmanHarris:
      return "blackman-harris";
    case PixelFilter::kBox:
      break;
  }
  return "box";
}

double filterRadius(PixelFilter filter) {
  return shapeOf(filter).radius;
}

std::vector<float> filterTable(PixelFilter filter) {
  if (filter == PixelFilter::kBox) return {};
  const Shape shape = shapeOf(filter);
  const double width = 2.0 * shape.radius / kSteps;
  const auto middle = [&](int step) { return -shape.radius + (step + 0.5) * width; };
  double total = 0.0;
  for (int step = 0; step < kSteps; ++step) total += shape.weight(middle(step));

  std::vector<float> table{static_cast<float>(-shape.radius)};
  double below = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    const double weight = shape.weight(middle(step));
    below += weight;
    // Entries whose share this step passes lie within the step.
    for (double share = 0.0; static_cast<int>(table.size()) < kTableSize - 1;) {
      share = total * static_cast<double>(table.size()) / (kTableSize - 1);
      if (share > below) break;
      table.push_back(static_cast<float>(middle(step) + width * (0.5 - (below - share) / weight)));
    }
  }
  table.resize(kTableSize, static_cast<float>(shape.radius));
  return table;
}

}  // namespace lavaray
