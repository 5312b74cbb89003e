#include "image/difference.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace lavaray {

double Difference::psnr() const {
  return rmse > 0.0 ? -20.0 * std::log10(rmse) : std::numeric_limits<double>::infinity();
}

Difference compare(const Image& image, const Image& reference, double tolerance) {
  assert(image.width == reference.width && image.height == reference.height);
  Difference result;
  result.pixels = image.rgb.size() / 3;
  double squares = 0.0;
  for (std::size_t pixel = 0; pixel < result.pixels; ++pixel) {
    double worst = 0.0;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      const double off = std::abs(double{image.rgb[i]} - double{reference.rgb[i]});
      squares += off * off;
      // Not max(), in which a NaN would vanish.
      if (!(off <= worst)) worst = std::isnan(off) ? std::numeric_limits<double>::infinity() : off;
    }
    if (worst > tolerance) ++result.differing;
    if (worst > result.largest) {
      result.largest = worst;
      result.x = static_cast<int>(pixel % image.width);
      result.y = static_cast<int>(pixel / image.width);
    }
  }
  result.rmse = image.rgb.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(image.rgb.size()));
  return result;
}

Image differencePicture(const Image& image, const Image& reference) {
  Image picture = image;
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    picture.rgb[i] = std::abs(image.rgb[i] - reference.rgb[i]);
  }
  normalize(picture);
  return picture;
}

}  // namespace lavaray
