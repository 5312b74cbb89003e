#pragma once

#include <cstdint>
#include <vector>

#include "image/bmp_header.hpp"

namespace lavaray {

// The pixels of a BMP image that is compressed as run lengths (RLE4 or RLE8): indices into its palette, row
// by row from the bottom. Throws Error(kInput), also where pixels are left out: programs fill these in
// different ways.
std::vector<std::uint8_t> readBmpRuns(const EncodedImage& file, const BmpHeader& header);

}  // namespace lavaray
