#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <lavaray/statistics.h>

#include "image/image.hpp"

namespace lavaray {

using v0::ChannelDifference;
using v0::Difference;

// Peak signal-to-noise ratio in dB, for a peak of 1; infinite for equal values.
double psnr(double rmse);

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
