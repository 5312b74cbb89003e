#pragma once

#include <cstddef>

#include "image/image.hpp"

namespace lavaray {

// How two images of one size differ; values in 0..1.
struct Difference {
  std::size_t pixels = 0;
  std::size_t differing = 0;  // pixels with a channel that is off by more than the tolerance
  double largest = 0.0;       // over all channels; at pixel (x, y)
  int x = 0;
  int y = 0;
  double rmse = 0.0;                  // over all channels
  [[nodiscard]] double psnr() const;  // in dB, for a peak of 1; infinite for equal images
};

Difference compare(const Image& image, const Image& reference, double tolerance);

// |image - reference|, stretched so that the largest difference is 1.
Image differencePicture(const Image& image, const Image& reference);

}  // namespace lavaray
