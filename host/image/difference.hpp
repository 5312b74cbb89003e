#pragma once

#include <cstddef>
#include <vector>

#include "image/image.hpp"

namespace lavaray {

// How far the values of some channels are apart; where they are finite.
struct ChannelDifference {
  std::size_t differing = 0;  // pixels that are off by more than the tolerance
  double largest = 0.0;       // at pixel (x, y)
  int x = 0;
  int y = 0;
  double rmse = 0.0;
  [[nodiscard]] double psnr() const;  // in dB, for a peak of 1; infinite for equal values
};

// How two images of one size differ. A pixel that is finite in both counts in the figures of its channels; of
// one that is not, it only matters whether both have the same values there, where any NaN is the same as any
// other.
struct Difference {
  std::size_t pixels = 0;
  std::size_t differing = 0;  // pixels with a channel off by more than the tolerance, alpha too, or unlike
  std::size_t finite = 0;     // pixels that are finite in both
  std::size_t unlike =
      0;  // others, whose values are not the same in both; the first is at (unlikeX, unlikeY)
  int unlikeX = 0;
  int unlikeY = 0;
  ChannelDifference color;
  ChannelDifference alpha;  // an image without alpha has 1
};

Difference compare(const Image& image, const Image& reference, double tolerance);

// For each pixel whether all of its channels are finite in both images.
std::vector<bool> finiteInBoth(const Image& image, const Image& reference);

// |image - reference|, stretched so that the largest difference is 1; that of alpha is grey where it is
// larger than the colours'. Where infinity or NaN is in one image only the picture is magenta.
Image differencePicture(const Image& image, const Image& reference);

// An image of floats as the file that the other one, of integers, was read from would hold it: a value c
// becomes trunc(maximum c) / maximum, as lavaray writes it. One that is the other image's value, and one that
// is not finite, stays.
Image asWritten(const Image& floats, const Image& integers);

}  // namespace lavaray
