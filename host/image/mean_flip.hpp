#pragma once

#include <vector>

#include "image/image.hpp"

namespace lavaray {

// FLIP of two images of the same size as a display shows them: two images of floats are first
// quantised as in an 8-bit file. The mean is over the pixels that are finite in both; all others are made
// black in both. If either image has alpha, both are composited over black and over white, and the larger
// mean counts, and its map.
struct SeenDifference {
  double mean = 0.0;
  std::vector<float> map{};  // of each pixel, 0 where one is not finite
};
SeenDifference seenDifference(const Image& image, const Image& reference, unsigned threads);

// Its mean alone.
double meanFlip(const Image& image, const Image& reference, unsigned threads);

}  // namespace lavaray
