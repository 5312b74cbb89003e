#include "image/difference.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace lavaray {
namespace {

using Pixel = std::array<float, 4>;

Pixel pixelOf(const Image& image, std::size_t i) {
  const float alpha = image.alpha.empty() ? 1.0F : image.alpha[i];
  return {image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2], alpha};
}

bool isFinite(const Pixel& pixel) {
  return std::all_of(pixel.begin(), pixel.end(), [](float value) { return std::isfinite(value); });
}

bool isSame(float a, float b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool isSame(const Pixel& a, const Pixel& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](float x, float y) { return isSame(x, y); });
}

double distance(float a, float b) {
  return std::abs(double{a} - double{b});
}

double colorDistance(const Pixel& a, const Pixel& b) {
  return std::max({distance(a[0], b[0]), distance(a[1], b[1]), distance(a[2], b[2])});
}

// Counts a pixel whose values are `off` apart.
void add(double off, double tolerance, int x, int y, ChannelDifference& sum) {
  if (off > tolerance) ++sum.differing;
  if (off <= sum.largest) return;
  sum.largest = off;
  sum.x = x;
  sum.y = y;
}

double rootMean(double squares, std::size_t values) {
  return values == 0 ? 0.0 : std::sqrt(squares / static_cast<double>(values));
}

}  // namespace

double psnr(double rmse) {
  return rmse > 0.0 ? -20.0 * std::log10(rmse) : std::numeric_limits<double>::infinity();
}

Difference compare(const Image& image, const Image& reference, double tolerance) {
  assert(image.width == reference.width && image.height == reference.height);
  Difference result;
  result.pixels = image.rgb.size() / 3;
  double colorSquares = 0.0;
  double alphaSquares = 0.0;
  for (std::size_t i = 0; i < result.pixels; ++i) {
    const Pixel a = pixelOf(image, i);
    const Pixel b = pixelOf(reference, i);
    const int x = static_cast<int>(i % image.width);
    const int y = static_cast<int>(i / image.width);
    if (isFinite(a) && isFinite(b)) {
      ++result.finite;
      const double colorOff = colorDistance(a, b);
      const double alphaOff = distance(a[3], b[3]);
      add(colorOff, tolerance, x, y, result.color);
      add(alphaOff, tolerance, x, y, result.alpha);
      if (std::max(colorOff, alphaOff) > tolerance) ++result.differing;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        colorSquares += std::pow(distance(a[channel], b[channel]), 2);
      }
      alphaSquares += alphaOff * alphaOff;
    } else if (!isSame(a, b)) {
      ++result.differing;
      if (result.unlike++ > 0) continue;
      result.unlikeX = x;
      result.unlikeY = y;
    }
  }
  result.color.rmse = rootMean(colorSquares, 3 * result.finite);
  result.alpha.rmse = rootMean(alphaSquares, result.finite);
  return result;
}

double toleranceOf(double levels) {
  return levels > 0.0 ? levels / 255.0 + 0x1p-23 : 0.0;
}

DifferenceHistogram differenceHistogram(const Image& image, const Image& reference) {
  std::array<double, kHistogramLevels.size()> most{};
  std::transform(kHistogramLevels.begin(), kHistogramLevels.end(), most.begin(), toleranceOf);
  DifferenceHistogram result{};
  for (std::size_t i = 0; i < image.rgb.size() / 3; ++i) {
    const Pixel a = pixelOf(image, i);
    const Pixel b = pixelOf(reference, i);
    if (!isFinite(a) || !isFinite(b)) continue;
    const double off = std::max(colorDistance(a, b), distance(a[3], b[3]));
    ++result[std::lower_bound(most.begin(), most.end(), off) - most.begin()];
  }
  return result;
}

std::vector<bool> finiteInBoth(const Image& image, const Image& reference) {
  std::vector<bool> isFiniteInBoth(image.rgb.size() / 3);
  for (std::size_t i = 0; i < isFiniteInBoth.size(); ++i) {
    isFiniteInBoth[i] = isFinite(pixelOf(image, i)) && isFinite(pixelOf(reference, i));
  }
  return isFiniteInBoth;
}

Image differencePicture(const Image& image, const Image& reference) {
  const Difference difference = compare(image, reference, 0.0);
  const double largest = std::max(difference.color.largest, difference.alpha.largest);
  Image picture{image.width, image.height, std::vector<float>(image.rgb.size())};
  for (std::size_t i = 0; i < difference.pixels; ++i) {
    const Pixel a = pixelOf(image, i);
    const Pixel b = pixelOf(reference, i);
    float* rgb = &picture.rgb[3 * i];
    if (isSame(a, b)) continue;
    if (!isFinite(a) || !isFinite(b)) {
      rgb[0] = rgb[2] = 1.0F;
      continue;
    }
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double off = std::max(distance(a[channel], b[channel]), distance(a[3], b[3]));
      rgb[channel] = static_cast<float>(off / largest);
    }
  }
  return picture;
}

Image asWritten(const Image& floats, const Image& integers) {
  const auto written = [&](float value, float other, std::size_t channel) {
    if (value == other || !std::isfinite(value)) return value;
    // The other image may have no alpha, and so no maximum for it.
    const std::uint32_t maximum = integers.source.maxima[channel];
    if (maximum == 0) return value;
    const double level = static_cast<double>(maximum) * std::clamp(double{value}, 0.0, 1.0);
    return static_cast<float>(std::floor(level)) / static_cast<float>(maximum);
  };
  Image result = floats;
  for (std::size_t i = 0; i < result.rgb.size(); ++i) {
    result.rgb[i] = written(floats.rgb[i], integers.rgb[i], i % 3);
  }
  for (std::size_t i = 0; i < result.alpha.size(); ++i) {
    result.alpha[i] = written(floats.alpha[i], integers.alpha.empty() ? 1.0F : integers.alpha[i], 3);
  }
  return result;
}

}  // namespace lavaray
