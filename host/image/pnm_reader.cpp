#include "image/pnm_reader.hpp"

#include <string>

#include "image/byte_order.hpp"
#include "image/pnm_scanner.hpp"

namespace lavaray {
namespace {

constexpr std::uint32_t kAnySide = 0xFFFFFFFF;  // checkSides() knows the limits

// `next` returns the file's values one after another.
template <typename Next>
void fill(Image& image, bool isGrey, const Next& next) {
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    image.rgb[i] = next();
    for (std::size_t channel = 1; channel < 3; ++channel) {
      image.rgb[i + channel] = isGrey ? image.rgb[i] : next();
    }
  }
}

// 1 is black.
Image readBitmap(const EncodedImage& file, PnmScanner& scanner, std::int64_t width, std::int64_t height) {
  const bool isText = file.bytes[1] == '1';
  const std::uint64_t rowBytes = static_cast<std::uint64_t>(width + 7) / 8;
  const std::string_view bits = isText ? std::string_view() : scanner.pixels(rowBytes * height);
  if (isText) scanner.requireText(static_cast<std::uint64_t>(width) * height);
  Image image = file.blankImage(width, height);
  std::int64_t x = 0;
  std::size_t row = 0;
  fill(image, true, [&] {
    if (isText) return quotient(1 - scanner.bit(), 1);
    const int byte = static_cast<unsigned char>(bits[row + static_cast<std::size_t>(x / 8)]);
    const bool isBlack = (byte >> (7 - x % 8) & 1) != 0;
    if (++x == width) {
      x = 0;
      row += rowBytes;
    }
    return isBlack ? 0.0F : 1.0F;
  });
  if (isText) scanner.requireEnd();
  return image;
}

}  // namespace

Image readPnm(const EncodedImage& file) {
  const char kind = file.bytes[1];
  const bool isBitmap = kind == '1' || kind == '4';
  const bool isGrey = kind != '3' && kind != '6';
  PnmScanner scanner(file);
  const std::int64_t width = scanner.number("its width", 1, kAnySide);
  const std::int64_t height = scanner.number("its height", 1, kAnySide);
  file.checkSides(width, height);
  const std::uint32_t maximum = isBitmap ? 1 : scanner.number("its maximum", 1, 65535);
  Image image;
  if (isBitmap) {
    image = readBitmap(file, scanner, width, height);
  } else {
    const std::uint64_t values = std::uint64_t{isGrey ? 1U : 3U} * width * height;
    const std::size_t valueBytes = maximum > 255 ? 2 : 1;
    const bool isText = kind <= '3';
    if (isText) scanner.requireText(2 * values);  // each takes at least a blank and a digit
    const std::string_view pixels = isText ? std::string_view() : scanner.pixels(valueBytes * values);
    image = file.blankImage(width, height);
    std::size_t at = 0;
    fill(image, isGrey, [&] {
      if (isText) return quotient(scanner.number("a pixel", 0, maximum), maximum);
      const std::uint32_t value = fromBigEndian(pixels.substr(at, valueBytes));
      at += valueBytes;
      if (value > maximum) {
        file.fail("a pixel is " + std::to_string(value) + "; its maximum allows 0 to " +
                  std::to_string(maximum));
      }
      return quotient(value, maximum);
    });
    if (isText) scanner.requireEnd();
  }
  image.source.maxima = {maximum, maximum, maximum, maximum};
  return image;
}

}  // namespace lavaray
