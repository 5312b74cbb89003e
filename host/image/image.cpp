#include "image/image.hpp"

#include <algorithm>

namespace lavaray {

float normalize(Image& image) {
  const auto largest = std::max_element(image.rgb.begin(), image.rgb.end());
  if (largest == image.rgb.end() || *largest <= 0.0F) return 0.0F;
  const float scale = *largest;  // a divisor, not a factor, so that the largest becomes exactly 1
  for (float& value : image.rgb) value /= scale;
  return scale;
}

Image crop(const Image& image, const Rectangle& part) {
  Image result{part.width(), part.height(), {}};
  result.rgb.reserve(std::size_t{3} * result.width * result.height);
  for (int y = part.y0; y < part.y1; ++y) {
    const auto row = image.rgb.begin() + std::ptrdiff_t{3} * image.width * y;
    result.rgb.insert(result.rgb.end(), row + std::ptrdiff_t{3} * part.x0, row + std::ptrdiff_t{3} * part.x1);
  }
  return result;
}

}  // namespace lavaray
