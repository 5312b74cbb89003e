#pragma once

#include <numbers>
#include <vector>

#include "image/image.hpp"

namespace lavaray {

// How different two images look to someone who alternates between them in the same place. Based on:
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference Evaluator for
// Alternating Images", 2020, in its version for images of low dynamic range.

// The authors' own setting: a display 0.7 m wide with 3840 pixels, seen from 0.7 m.
inline constexpr double kFlipPixelsPerDegree = 0.7 * (3840.0 / 0.7) * std::numbers::pi / 180.0;

// FLIP of each pixel, from 0 (they look the same) to 1, row by row from the top. The images must have the
// same size and values in [0, 1], which are taken to be sRGB-encoded. Within about ten pixels of a NaN the
// result is NaN too.
std::vector<float> flipMap(const Image& image, const Image& reference, unsigned threads);

}  // namespace lavaray
