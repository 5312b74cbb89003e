#pragma once

#include <cstdint>
#include <vector>

#include "image/bmp_header.hpp"

namespace lavaray {

// The pixels of a BMP image with run-length compression (RLE4 or RLE8): indices into its palette, row by row
// from the bottom. Throws Error(kInput), even if pixels are merely left out, since programs fill those in
// different ways.
std::vector<std::uint8_t> readBmpRuns(const EncodedImage& file, const BmpHeader& header);

}  // namespace lavaray
