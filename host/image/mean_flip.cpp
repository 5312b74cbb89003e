#include "image/mean_flip.hpp"

#include <algorithm>
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

double meanFlip(const Image& image, const Image& reference, unsigned threads) {
  const std::vector<bool> isFinite = finiteInBoth(image, reference);
  const auto count = std::count(isFinite.begin(), isFinite.end(), true);
  if (count == 0) return 0.0;
  const bool areFloats = image.source.maxima[0] == 0 && reference.source.maxima[0] == 0;
  const auto meanOver = [&](float background) {
    const std::vector<float> map = flipMap(displayed(image, isFinite, areFloats, background),
                                           displayed(reference, isFinite, areFloats, background), threads);
    double sum = 0.0;
    for (std::size_t i = 0; i < map.size(); ++i) sum += isFinite[i] ? double{map[i]} : 0.0;
    return sum / static_cast<double>(count);
  };
  const bool hasAlpha = !image.alpha.empty() || !reference.alpha.empty();
  return hasAlpha ? std::max(meanOver(0.0F), meanOver(1.0F)) : meanOver(0.0F);
}

}  // namespace lavaray
