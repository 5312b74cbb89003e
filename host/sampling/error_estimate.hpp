#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "sampling/pixel_sum.hpp"
#include "sampling/sample_allocation.hpp"

namespace lavaray {

// Estimates the squared error of each pixel of an image, and how it falls with more samples, from the samples
// of the pixel and its neighbours.
//
// Both halves of a pixel's samples are stratified, each by itself and together. Their means have the same
// distribution, so that their difference is not correlated with the mean of both, and to stop where it is
// small does not bias the image. From one pixel it is a rough estimate. So the differences of all pixels
// around say how the error falls there, and the variance of the samples of the pixel, and of neighbours that
// are like it, how large it is. That biases a little: samples that are all alike look easy, whichever of two
// values they missed. A pixel that differs from a neighbour may have an edge that all its samples have
// missed.
class ErrorEstimate {
 public:
  // Whether the samples of a pixel are stratified or independent. Squared errors far below `negligible` are
  // estimated less well, and too high.
  ErrorEstimate(int width, int height, bool isStratified, double negligible);

  static std::size_t bytesPerPixel() { return 1 + sizeof(Statistics) + sizeof(PixelClass); }

  // A pixel's samples have changed; update() looks at it and its neighbours.
  void mark(std::size_t pixel) { isMarked_[pixel] = 1; }
  void markAll();
  // `sums` of all pixels, each of a power of two of samples, at least two.
  void update(std::span<const HalfSums> sums);

  [[nodiscard]] std::span<const PixelClass> classes() const { return classes_; }

 private:
  // What a pixel's samples say, apart from its neighbours.
  struct Statistics {
    glm::vec3 mean;
    float variance;    // of a sample
    float difference;  // half of that of the halves' means, squared, times n^(3/2)
    int sampleStep;    // n is 2 to the power of it
  };

  [[nodiscard]] static Statistics statistics(const HalfSums& sums);
  [[nodiscard]] PixelClass classOf(int x, int y) const;
  [[nodiscard]] int usualRateStep(int x, int y, float variance) const;
  [[nodiscard]] int rateStepAround(int x, int y, int usualRateStep) const;
  void updateRow(int y);

  int width_;
  int height_;
  bool isStratified_;
  float negligible_;
  std::vector<std::uint8_t> isMarked_;
  std::vector<Statistics> statistics_;
  std::vector<PixelClass> classes_;
};

}  // namespace lavaray
