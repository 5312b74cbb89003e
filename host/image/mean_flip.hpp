#pragma once

#include "image/image.hpp"

namespace lavaray {

// The mean FLIP of two images of the same size as a display shows them: two images of floats are first
// quantised as in an 8-bit file. The mean is over the pixels that are finite in both; all others are made
// black in both. If either image has alpha, both are composited over black and over white, and the larger
// mean counts.
double meanFlip(const Image& image, const Image& reference, unsigned threads);

}  // namespace lavaray
