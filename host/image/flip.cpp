#include "image/flip.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "base/parallel.hpp"
#include "image/color_spaces.hpp"
#include "image/flip_filters.hpp"

namespace lavaray {
namespace {

// The paper's q_c, p_c, p_t (colour) and q_f (features).
constexpr float kColorExponent = 0.7F;
constexpr float kColorKnee = 0.4F;
constexpr float kKneeValue = 0.95F;
constexpr float kFeatureExponent = 0.5F;
constexpr float kInverseRoot2 = 0.70710678F;

// Rows processed at a time: few enough to stay in a processor's cache.
constexpr int kBandRows = 64;

// A pixel as perceived.
struct Percept {
  glm::vec3 color;  // L*a*b*, the last two weighted by L*: the Hunt effect
  float edge;
  float point;
};

glm::vec3 huntAdjusted(const glm::vec3& lab) {
  return {lab.x, 0.01F * lab.x * lab.y, 0.01F * lab.x * lab.z};
}

// Abasi, Amani Tehran and Fairchild, "Distance Metrics for Very Large Color Differences", 2019.
float hyab(const glm::vec3& a, const glm::vec3& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

float compressedDistance(const glm::vec3& a, const glm::vec3& b) {
  return std::pow(hyab(a, b), kColorExponent);
}

// The largest distance between displayable colours: that of pure green and pure blue.
float largestDistance() {
  return compressedDistance(huntAdjusted(labFromLinear({0.0F, 1.0F, 0.0F})),
                            huntAdjusted(labFromLinear({0.0F, 0.0F, 1.0F})));
}

// Distances up to the knee, a fraction of the largest, map to most of [0, 1]; the few beyond it share the
// rest.
float colorDifference(const glm::vec3& a, const glm::vec3& b, float largest) {
  const float distance = compressedDistance(a, b);
  const float knee = kColorKnee * largest;
  if (distance < knee) return kKneeValue * distance / knee;
  return kKneeValue + (1.0F - kKneeValue) * (distance - knee) / (largest - knee);
}

float featureDifference(const Percept& a, const Percept& b) {
  const float largest = std::max(std::abs(a.edge - b.edge), std::abs(a.point - b.point));
  return std::pow(kInverseRoot2 * largest, kFeatureExponent);
}

// The rows [y0, y1) of an image as perceived. Beyond the image's edges its nearest pixel repeats.
class Band {
 public:
  Band(const Image& image, const FlipFilters& filters, int y0, int y1)
      : filters_(filters), width_(static_cast<std::size_t>(image.width)), rows_(y1 - y0) {
    const auto count = width_ * static_cast<std::size_t>(rows_ + 2 * filters.maxRadius);
    for (std::vector<float>& values : across_) values.resize(count);
    for (int row = 0; row < rows_ + 2 * filters.maxRadius; ++row) {
      filterAcross(image, std::clamp(y0 - filters.maxRadius + row, 0, image.height - 1), row);
    }
  }

  // `row` counts from y0.
  [[nodiscard]] std::vector<Percept> percepts(int row) const {
    const auto down = [&](Plane plane, const Kernel& kernel, std::vector<float>& sum) {
      const int first = row + filters_.maxRadius - radius(kernel);
      for (std::size_t i = 0; i < kernel.size(); ++i) {
        addScaled(kernel[i],
                  &across_[static_cast<std::size_t>(plane)][width_ * (static_cast<std::size_t>(first) + i)],
                  sum);
      }
    };
    std::array<std::vector<float>, 3> opponent;
    std::array<std::vector<float>, 4> features;
    for (std::vector<float>& sum : opponent) sum.resize(width_);
    for (std::vector<float>& sum : features) sum.resize(width_);
    down(Plane::kAchromatic, filters_.achromatic.down, opponent[0]);
    down(Plane::kRedGreen, filters_.redGreen.down, opponent[1]);
    down(Plane::kBlueYellowWide, filters_.blueYellowWide.down, opponent[2]);
    down(Plane::kBlueYellowNarrow, filters_.blueYellowNarrow.down, opponent[2]);
    down(Plane::kEdge, filters_.smooth, features[0]);
    down(Plane::kSmooth, filters_.edge, features[1]);
    down(Plane::kPoint, filters_.smooth, features[2]);
    down(Plane::kSmooth, filters_.point, features[3]);

    std::vector<Percept> result(width_);
    for (std::size_t x = 0; x < width_; ++x) {
      const glm::vec3 linear = linearFromOpponent({opponent[0][x], opponent[1][x], opponent[2][x]});
      result[x] = {huntAdjusted(labFromLinear(glm::clamp(linear, 0.0F, 1.0F))),
                   std::hypot(features[0][x], features[1][x]), std::hypot(features[2][x], features[3][x])};
    }
    return result;
  }

 private:
  // What is kept of each row after filtering along it.
  enum class Plane { kAchromatic, kRedGreen, kBlueYellowWide, kBlueYellowNarrow, kEdge, kSmooth, kPoint };
  static constexpr std::size_t kPlaneCount = 7;

  static void addScaled(float factor, const float* values, std::vector<float>& sum) {
    for (std::size_t x = 0; x < sum.size(); ++x) sum[x] += factor * values[x];
  }

  void filterAcross(const Image& image, int y, int row) {
    // The row's opponent channels, extended at both ends.
    const std::size_t margin = static_cast<std::size_t>(filters_.maxRadius);
    std::array<std::vector<float>, 3> padded;
    for (std::vector<float>& channel : padded) channel.resize(width_ + 2 * margin);
    for (std::size_t x = 0; x < width_; ++x) {
      const float* rgb = &image.rgb[3 * (static_cast<std::size_t>(y) * width_ + x)];
      const glm::vec3 color =
          opponentFromLinear({linearFromSrgb(rgb[0]), linearFromSrgb(rgb[1]), linearFromSrgb(rgb[2])});
      for (int channel = 0; channel < 3; ++channel) padded[channel][x + margin] = color[channel];
    }
    for (std::vector<float>& channel : padded) {
      std::fill_n(channel.begin(), margin, channel[margin]);
      std::fill_n(channel.end() - filters_.maxRadius, margin, channel[margin + width_ - 1]);
    }
    std::vector<float> sum(width_);
    const auto across = [&](Plane plane, const Kernel& kernel, const std::vector<float>& channel) {
      std::fill(sum.begin(), sum.end(), 0.0F);
      const std::size_t first = margin - static_cast<std::size_t>(radius(kernel));
      for (std::size_t i = 0; i < kernel.size(); ++i) addScaled(kernel[i], &channel[first + i], sum);
      std::copy(sum.begin(), sum.end(),
                across_[static_cast<std::size_t>(plane)].begin() + std::ptrdiff_t(width_) * row);
    };
    across(Plane::kAchromatic, filters_.achromatic.across, padded[0]);
    across(Plane::kRedGreen, filters_.redGreen.across, padded[1]);
    across(Plane::kBlueYellowWide, filters_.blueYellowWide.across, padded[2]);
    across(Plane::kBlueYellowNarrow, filters_.blueYellowNarrow.across, padded[2]);
    across(Plane::kEdge, filters_.edge, padded[0]);
    across(Plane::kSmooth, filters_.smooth, padded[0]);
    across(Plane::kPoint, filters_.point, padded[0]);
  }

  const FlipFilters& filters_;
  std::size_t width_;
  int rows_;
  std::array<std::vector<float>, kPlaneCount> across_;
};

}  // namespace

std::vector<float> flipMap(const Image& image, const Image& reference, unsigned threads) {
  assert(image.width == reference.width && image.height == reference.height);
  std::vector<float> map(image.rgb.size() / 3);
  const FlipFilters filters = flipFilters(kFlipPixelsPerDegree);
  const float largest = largestDistance();
  const int bands = (image.height + kBandRows - 1) / kBandRows;
  parallelFor(static_cast<std::size_t>(bands), threads, [&](std::size_t index) {
    const int y0 = static_cast<int>(index) * kBandRows;
    const int y1 = std::min(y0 + kBandRows, image.height);
    const Band band(image, filters, y0, y1);
    const Band referenceBand(reference, filters, y0, y1);
    for (int y = y0; y < y1; ++y) {
      const std::vector<Percept> a = band.percepts(y - y0);
      const std::vector<Percept> b = referenceBand.percepts(y - y0);
      float* row = &map[static_cast<std::size_t>(y) * a.size()];
      for (std::size_t x = 0; x < a.size(); ++x) {
        row[x] =
            std::pow(colorDifference(a[x].color, b[x].color, largest), 1.0F - featureDifference(a[x], b[x]));
      }
    }
  });
  return map;
}

}  // namespace lavaray
