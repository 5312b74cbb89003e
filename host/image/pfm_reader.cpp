#include "image/pfm_reader.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

#include "base/text_location.hpp"
#include "image/pnm_scanner.hpp"

namespace lavaray {
namespace {

// 1 or -1. Of any other magnitude programs make different numbers: some multiply by it, some divide, some
// leave it.
double readScale(const ImageBytes& file, PnmWords& words) {
  const std::string_view text = words.word();
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double scale = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), scale);
  const bool isRead = error == std::errc() && end == digits.data() + digits.size();
  if (isRead && std::abs(scale) == 1.0) return scale;
  file.fail("its scale is " + quoted(text) +
            "; allowed are 1 and -1, since programs multiply by any other, divide by it or leave it");
}

}  // namespace

Image readPfm(const ImageBytes& file) {
  const std::size_t channels = file.bytes[1] == 'f' ? 1 : 3;
  PnmWords words(file);
  const std::int64_t width = words.number("its width", 1, 0xFFFFFFFF);
  const std::int64_t height = words.number("its height", 1, 0xFFFFFFFF);
  file.checkSides(width, height);
  const double scale = readScale(file, words);
  const std::string_view pixels = words.pixels(4 * channels * static_cast<std::uint64_t>(width) * height);
  const ImageBytes floats{pixels, file.file};
  Image image = file.blankImage(width, height);
  const std::size_t rowSize = channels * static_cast<std::size_t>(width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    const std::size_t row = (static_cast<std::size_t>(height) - 1 - y) * rowSize;  // the lowest comes first
    for (std::size_t i = 0; i < std::size_t{3} * image.width; ++i) {
      std::uint32_t bits = floats.little(4 * (row + (channels == 1 ? i / 3 : i)), 4);
      if (scale > 0.0) bits = bits << 24 | (bits & 0xFF00) << 8 | (bits >> 8 & 0xFF00) | bits >> 24;
      image.rgb[y * 3 * image.width + i] = std::bit_cast<float>(bits);
    }
  }
  return image;
}

}  // namespace lavaray
