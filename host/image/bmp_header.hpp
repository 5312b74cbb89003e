#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/encoded_image.hpp"

namespace lavaray {

// The bits of a pixel that hold one of its channels. A channel without bits is absent.
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
  bool hasReservedByte = false;                      // the fourth of 32 bits, if no mask says what it is
  int bits = 0;                                      // per pixel: 1, 2, 4, 8, 16, 24 or 32
  std::size_t pixelsAt = 0;                          // position in the file
  std::vector<std::array<std::uint8_t, 3>> palette;  // red, green, blue; not empty for up to 8 bits
  std::array<BmpMask, 4> masks;                      // red, green, blue, alpha; for more than 8 bits

  [[nodiscard]] bool hasPalette() const { return bits <= 8; }
};

// Reads the header of any Windows or OS/2 version of BMP. Throws Error(kInput) if it is damaged, or describes
// a variant that is not supported, which the message names.
BmpHeader readBmpHeader(const EncodedImage& file);

}  // namespace lavaray
