#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/encoded_image.hpp"

namespace lavaray {

// The bits of a pixel that hold one of its channels. Without any the channel is absent.
struct BmpMask {
  std::uint32_t bits = 0;
  int shift = 0;
  std::uint32_t maximum = 0;

  [[nodiscard]] std::uint32_t extract(std::uint32_t pixel) const { return (pixel & bits) >> shift; }
};

struct BmpHeader {
  std::int64_t width = 0;
  std::int64_t height = 0;
  bool isTopDown = false;
  bool isRunLength = false;
  bool hasReservedByte = false;                      // the fourth of 32 bits, where no mask says what it is
  int bits = 0;                                      // a pixel: 1, 2, 4, 8, 16, 24 or 32
  std::size_t pixelsAt = 0;                          // in the file
  std::vector<std::array<std::uint8_t, 3>> palette;  // red, green, blue; for up to 8 bits, never empty then
  std::array<BmpMask, 4> masks;                      // red, green, blue, alpha; for more than 8 bits

  [[nodiscard]] bool hasPalette() const { return bits <= 8; }
};

// Reads the header of any Windows or OS/2 version that BMP files have. Throws Error(kInput) for what is
// damaged, and, by its name, for a variant that is not read.
BmpHeader readBmpHeader(const EncodedImage& file);

}  // namespace lavaray
