#include "support/image_compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace lavaray {
namespace {

void requireSize(std::size_t values, const oracle::Result& oracle) {
  const std::size_t expected = 3 * oracle.pixels.size();
  if (values == expected) return;
  std::ostringstream message;
  message << "the image has " << values << " values where " << oracle.width << " x " << oracle.height
          << " pixels make " << expected;
  throw std::invalid_argument(message.str());
}

bool isAtEdge(const oracle::Result& oracle, int x, int y) {
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, oracle.height - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, oracle.width - 1); ++u) {
      if (oracle.pixels[static_cast<std::size_t>(v * oracle.width + u)].uncertain) return true;
    }
  }
  return false;
}

}  // namespace

Comparison compare(const std::vector<float>& rgb, const oracle::Result& expected) {
  requireSize(rgb.size(), expected);
  // Half a float step of slack, so that a difference of exactly one level passes.
  constexpr double kTolerance = 1.0 / 255.0 + 1e-7;
  Comparison result;
  result.total = static_cast<int>(expected.pixels.size());
  for (int i = 0; i < result.total; ++i) {
    const oracle::Pixel& pixel = expected.pixels[static_cast<std::size_t>(i)];
    if (pixel.uncertain) {
      ++result.uncertain;
      continue;
    }
    double largest = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
      const double difference = std::abs(static_cast<double>(rgb[static_cast<std::size_t>(3 * i + channel)]) -
                                         pixel.color[channel]);
      largest = std::isnan(difference) ? HUGE_VAL : std::max(largest, difference);
    }
    if (largest > kTolerance) ++result.wrong;
    if (largest > result.maxDifference) {
      result.maxDifference = largest;
      result.maxX = i % expected.width;
      result.maxY = i / expected.width;
    }
  }
  return result;
}

bool showsAlternative(const std::vector<float>& rgb, std::size_t index, const oracle::Pixel& expected) {
  constexpr double kHalfLevel = 0.5 / 255.0;
  return std::ranges::any_of(expected.alternatives, [&](const glm::dvec3& color) {
    double largest = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
      const double difference =
          std::abs(double{rgb[3 * index + static_cast<std::size_t>(channel)]} - color[channel]);
      largest = std::isnan(difference) ? HUGE_VAL : std::max(largest, difference);
    }
    return largest <= kHalfLevel;
  });
}

std::string describe(const Comparison& comparison) {
  std::ostringstream text;
  text << comparison.wrong << " of " << comparison.total << " pixels wrong, largest difference "
       << comparison.maxDifference * 255.0 << " levels at (" << comparison.maxX << ", " << comparison.maxY
       << "), " << comparison.uncertain << " pixels uncertain (" << 100.0 * comparison.uncertainShare()
       << " %)";
  return text.str();
}

ByteComparison compareBytes(const std::vector<std::uint8_t>& actual,
                            const std::vector<std::uint8_t>& expected, const oracle::Result& oracle) {
  requireSize(actual.size(), oracle);
  requireSize(expected.size(), oracle);
  ByteComparison result;
  for (std::size_t i = 0; i < oracle.pixels.size(); ++i) {
    int largest = 0;
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
      largest = std::max(largest, std::abs(actual[k] - expected[k]));
    if (largest == 0) continue;
    ++result.differing;
    result.maxDifference = std::max(result.maxDifference, largest);
    const int pixel = static_cast<int>(i);
    if (largest > 1 && !isAtEdge(oracle, pixel % oracle.width, pixel / oracle.width)) ++result.wrong;
  }
  return result;
}

std::string describe(const ByteComparison& comparison) {
  std::ostringstream text;
  text << comparison.differing << " pixels differ, by " << comparison.maxDifference << " levels at most, "
       << comparison.wrong << " by more than one level off the edges";
  return text.str();
}

std::vector<std::uint8_t> truncatedBytes(const oracle::Result& image, bool stretch) {
  double scale = 255.0;
  if (stretch) {
    double largest = 0.0;
    for (const oracle::Pixel& pixel : image.pixels) {
      largest = std::max({largest, pixel.color.x, pixel.color.y, pixel.color.z});
    }
    if (largest > 0.0) scale /= largest;
  }
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * image.pixels.size());
  for (const oracle::Pixel& pixel : image.pixels) {
    for (int channel = 0; channel < 3; ++channel) {
      bytes.push_back(static_cast<std::uint8_t>(std::clamp(scale * pixel.color[channel], 0.0, 255.0)));
    }
  }
  return bytes;
}

}  // namespace lavaray
