#include "image/bmp_reader.hpp"

#include <string>

#include "image/bmp_header.hpp"
#include "image/bmp_run_lengths.hpp"

namespace lavaray {
namespace {

// The index in the image of a pixel whose row is counted in file order.
std::size_t pixelAt(const BmpHeader& header, std::size_t x, std::size_t row) {
  const auto height = static_cast<std::size_t>(header.height);
  const std::size_t y = header.isTopDown ? row : height - 1 - row;
  return y * static_cast<std::size_t>(header.width) + x;
}

// `indexOf` returns the palette index of the pixel at column x of a row, counted in file order.
template <typename IndexOf>
void fillFromPalette(const EncodedImage& file, const BmpHeader& header, const IndexOf& indexOf,
                     Image& image) {
  for (std::size_t row = 0; row < static_cast<std::size_t>(header.height); ++row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(header.width); ++x) {
      const std::size_t index = indexOf(x, row);
      if (index >= header.palette.size()) {
        file.fail("is a BMP image with a pixel of colour " + std::to_string(index) +
                  "; its palette has 0 to " + std::to_string(header.palette.size() - 1));
      }
      float* rgb = &image.rgb[3 * pixelAt(header, x, row)];
      for (std::size_t i = 0; i < 3; ++i) rgb[i] = quotient(header.palette[index][i], 255);
    }
  }
  image.source.maxima = {255, 255, 255, 255};
}

void fillFromMasks(const EncodedImage& file, const BmpHeader& header, std::size_t rowBytes, Image& image) {
  const BmpMask& alpha = header.masks[3];
  if (alpha.bits != 0) image.alpha.resize(image.rgb.size() / 3);
  const auto bytes = static_cast<std::size_t>(header.bits / 8);
  std::uint32_t set = 0;    // in any pixel
  std::uint32_t all = ~0U;  // in all pixels
  for (std::size_t row = 0; row < static_cast<std::size_t>(header.height); ++row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(header.width); ++x) {
      const std::uint32_t pixel = file.littleEndian(header.pixelsAt + row * rowBytes + x * bytes, bytes);
      const std::size_t at = pixelAt(header, x, row);
      for (std::size_t i = 0; i < 3; ++i) {
        image.rgb[3 * at + i] = quotient(header.masks[i].extract(pixel), header.masks[i].maximum);
      }
      if (alpha.bits != 0) image.alpha[at] = quotient(alpha.extract(pixel), alpha.maximum);
      set |= pixel;
      all &= pixel;
    }
  }
  for (std::size_t i = 0; i < 4; ++i) image.source.maxima[i] = header.masks[i].maximum;
  if (header.hasReservedByte && set >> 24 != all >> 24) {
    image.source.notes.emplace_back(
        "the fourth byte of its pixels, which some programs take for alpha, is not "
        "looked at: its header does not call it that");
  }
}

}  // namespace

Image readBmp(const EncodedImage& file) {
  const BmpHeader header = readBmpHeader(file);
  if (header.isRunLength) {
    const std::vector<std::uint8_t> indices = readBmpRuns(file, header);
    Image image = file.blankImage(header.width, header.height);
    const auto width = static_cast<std::size_t>(header.width);
    fillFromPalette(
        file, header, [&](std::size_t x, std::size_t row) { return indices[row * width + x]; }, image);
    return image;
  }
  const auto bits = static_cast<std::size_t>(header.bits);
  const std::size_t rowBytes = (static_cast<std::size_t>(header.width) * bits + 31) / 32 * 4;
  if ((file.bytes.size() - header.pixelsAt) / rowBytes < static_cast<std::size_t>(header.height)) {
    file.failAsCutOff();
  }
  Image image = file.blankImage(header.width, header.height);
  if (!header.hasPalette()) {
    fillFromMasks(file, header, rowBytes, image);
    return image;
  }
  const auto indexOf = [&](std::size_t x, std::size_t row) -> std::size_t {
    const auto byte = static_cast<unsigned char>(file.bytes[header.pixelsAt + row * rowBytes + x * bits / 8]);
    return byte >> (8 - bits - x * bits % 8) & ((1U << bits) - 1);
  };
  fillFromPalette(file, header, indexOf, image);
  return image;
}

}  // namespace lavaray
