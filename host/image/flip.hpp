#pragma once

#include <numbers>
#include <vector>

#include "image/image.hpp"

namespace lavaray {

// How much two images differ to someone who looks at one and then the other in its place.
// Based on: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", 2020, in its version for images of low dynamic range.

// As the authors have it: a display 0.7 m wide with 3840 pixels, seen from 0.7 m.
inline constexpr double kFlipPixelsPerDegree = 0.7 * (3840.0 / 0.7) * std::numbers::pi / 180.0;

// FLIP of each pixel, 0 (they look alike) to 1, row by row from the top. The images have one size and values
// in [0, 1], which are taken as sRGB-encoded. It is not a number within about ten pixels of such a value.
std::vector<float> flipMap(const Image& image, const Image& reference, unsigned threads);

}  // namespace lavaray
