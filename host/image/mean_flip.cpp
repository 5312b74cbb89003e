#include "image/mean_flip.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "image/difference.hpp"
#include "image/flip.hpp"

namespace lavaray {
namespace {

// Composited over the background, in [0, 1], and black where `isShown` is false.
Image displayed(const Image& image, const std::vector<bool>& isShown, bool isTruncated, float background) {
  Image result{image.width, image.height, image.rgb};
  for (std::size_t i = 0; i < result.rgb.size(); ++i) {
    float& value = result.rgb[i];
    if (!isShown[i / 3]) {
      value = 0.0F;
      continue;
    }
    value = std::clamp(value, 0.0F, 1.0F);
    if (isTruncated) value = static_cast<float>(toByte(value)) / 255.0F;
    if (image.alpha.empty()) continue;
    const float alpha = std::clamp(image.alpha[i / 3], 0.0F, 1.0F);
    value = alpha * value + (1.0F - alpha) * background;
  }
  return result;
}

}  // namespace

SeenDifference seenDifference(const Image& image, const Image& reference, unsigned threads) {
  const std::vector<bool> isFinite = finiteInBoth(image, reference);
  const auto count = std::count(isFinite.begin(), isFinite.end(), true);
  const bool areFloats = image.source.maxima[0] == 0 && reference.source.maxima[0] == 0;
  const auto over = [&](float background) {
    SeenDifference result;
    result.map = flipMap(displayed(image, isFinite, areFloats, background),
                         displayed(reference, isFinite, areFloats, background), threads);
    double sum = 0.0;
    for (std::size_t i = 0; i < result.map.size(); ++i) {
      if (!isFinite[i]) result.map[i] = 0.0F;
      sum += double{result.map[i]};
    }
    result.mean = count == 0 ? 0.0 : sum / static_cast<double>(count);
    return result;
  };
  SeenDifference overBlack = over(0.0F);
  if (image.alpha.empty() && reference.alpha.empty()) return overBlack;
  SeenDifference overWhite = over(1.0F);
  return overBlack.mean >= overWhite.mean ? std::move(overBlack) : std::move(overWhite);
}

double meanFlip(const Image& image, const Image& reference, unsigned threads) {
  return seenDifference(image, reference, threads).mean;
}

}  // namespace lavaray
