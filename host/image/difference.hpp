#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "image/image.hpp"

namespace lavaray {

// How far the finite values of some channels are apart.
struct ChannelDifference {
  std::size_t differing = 0;  // pixels that are off by more than the tolerance
  double largest = 0.0;       // at pixel (x, y)
  int x = 0;
  int y = 0;
  double rmse = 0.0;
  [[nodiscard]] double psnr() const;  // in dB, for a peak of 1; infinite for equal values
};

// How two images of the same size differ. A pixel that is finite in both counts towards the figures of its
// channels. Of any other it only matters whether both have the same values there; all NaNs count as the same.
struct Difference {
  std::size_t pixels = 0;
  std::size_t differing = 0;  // pixels with a channel, or alpha, off by more than the tolerance, or unlike
  std::size_t finite = 0;     // pixels that are finite in both
  // Other pixels, whose values are not the same in both; the first is at (unlikeX, unlikeY).
  std::size_t unlike = 0;
  int unlikeX = 0;
  int unlikeY = 0;
  ChannelDifference color;
  ChannelDifference alpha;  // of an image without alpha it is 1
};

Difference compare(const Image& image, const Image& reference, double tolerance);

// How many of the pixels that are finite in both differ, in alpha or the channel that is furthest off, by how
// much: in bin i by at most kHistogramLevels[i] / 255 and by more than the bin before allows, in the last by
// more than all of them.
inline constexpr std::array<int, 9> kHistogramLevels = {0, 1, 2, 4, 8, 16, 32, 64, 128};
using DifferenceHistogram = std::array<std::size_t, kHistogramLevels.size() + 1>;
DifferenceHistogram differenceHistogram(const Image& image, const Image& reference);

// What a tolerance of so many levels of 255 is in values. Each of two quotients, rounded to a float, is off
// by at most 2^-24: so a difference of exactly that many levels stays within it.
double toleranceOf(double levels);

// For each pixel, whether all of its channels are finite in both images.
std::vector<bool> finiteInBoth(const Image& image, const Image& reference);

// |image - reference|, scaled so that the largest difference is 1. A difference of alpha shows as grey where
// it is larger than those of the colours. Magenta marks infinities and NaNs that are not in both images.
Image differencePicture(const Image& image, const Image& reference);

// An image of floats as it would be in a file like the one that the other image, of integers, was read from:
// a value c becomes trunc(maximum c) / maximum, as lavaray writes it. Values that equal the other image's,
// and values that are not finite, stay.
Image asWritten(const Image& floats, const Image& integers);

}  // namespace lavaray
