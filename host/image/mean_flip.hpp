#pragma once

#include "image/image.hpp"

namespace lavaray {

// The mean FLIP of two images of one size as a display shows them: of two images of floats it takes what
// 8-bit files of them would hold. It is over the pixels that are finite in both; the others are black in
// both. Where an image has alpha, both are laid over black and over white, and the larger mean counts.
double meanFlip(const Image& image, const Image& reference, unsigned threads);

}  // namespace lavaray
