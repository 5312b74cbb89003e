#include "image/pfm_reader.hpp"

#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "base/number_text.hpp"
#include "base/text_location.hpp"
#include "image/byte_order.hpp"
#include "image/pnm_scanner.hpp"

namespace lavaray {
namespace {

// Returns 1 or -1. Programs disagree about any other magnitude: some multiply by it, some divide, some ignore
// it.
double readScale(const EncodedImage& file, PnmScanner& scanner) {
  const std::string_view text = scanner.word();
  const std::optional<double> scale = parseDecimal(text);
  if (scale && std::abs(*scale) == 1.0) return *scale;
  file.fail("its scale is " + quoted(text) +
            "; allowed are 1 and -1, since programs multiply by any other, divide by it or leave it");
}

}  // namespace

Image readPfm(const EncodedImage& file) {
  const std::size_t channels = file.bytes[1] == 'f' ? 1 : 3;
  PnmScanner scanner(file);
  const std::int64_t width = scanner.number("its width", 1, 0xFFFFFFFF);
  const std::int64_t height = scanner.number("its height", 1, 0xFFFFFFFF);
  file.checkSides(width, height);
  const double scale = readScale(file, scanner);
  const std::string_view pixels = scanner.pixels(4 * channels * static_cast<std::uint64_t>(width) * height);
  Image image = file.blankImage(width, height);
  const std::size_t rowSize = channels * static_cast<std::size_t>(width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    const std::size_t row = (static_cast<std::size_t>(height) - 1 - y) * rowSize;  // the lowest comes first
    for (std::size_t i = 0; i < std::size_t{3} * image.width; ++i) {
      const std::string_view bytes = pixels.substr(4 * (row + (channels == 1 ? i / 3 : i)), 4);
      image.rgb[y * 3 * image.width + i] =
          std::bit_cast<float>(scale > 0.0 ? fromBigEndian(bytes) : fromLittleEndian(bytes));
    }
  }
  return image;
}

}  // namespace lavaray
