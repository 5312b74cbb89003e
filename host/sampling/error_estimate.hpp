#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "sampling/picture_scale.hpp"
#include "sampling/pixel_sum.hpp"
#include "sampling/sample_allocation.hpp"

namespace lavaray {

// Estimates the squared error of each pixel of an image, and the rate at which it converges, from the samples
// of the pixel and its neighbours.
//
// The two halves of a pixel's samples are stratified, each by itself and both together. Their means have the
// same distribution, so their difference is uncorrelated with the mean of both, and stopping where it is
// small does not bias the image. But one pixel's difference is a rough estimate. Therefore the differences of
// all pixels around tell the convergence rate, and the variance of the samples of the pixel, and of
// neighbours that are like it, tells how large the error is. This introduces a small bias: samples that are
// all alike look easy, whichever of two values they missed. So the classes say how the error is spread over
// the picture, and scale() how large it is in all. Where a neighbour shows what the pixel's samples have not
// met, a class is of what they may have missed.
class ErrorEstimate {
 public:
  // The samples of a pixel are either stratified or independent. Squared errors far below `negligible` are
  // estimated less accurately, and too high.
  ErrorEstimate(int width, int height, bool isStratified, double negligible);

  static std::size_t bytesPerPixel() { return 1 + sizeof(Statistics) + sizeof(PixelClass); }

  // Says that a pixel's samples have changed: update() will look at it and its neighbours.
  void mark(std::size_t pixel) { isMarked_[pixel] = 1; }
  void markAll();
  // `sums` has all pixels, each with a power of two of samples, at least two.
  void update(std::span<const HalfSums> sums);
  // Does the part of the next update() that needs only the sums of the rows before `end`. They must not
  // change until then. Leaves half of the processor's threads alone, on which a device may compute.
  void updateRows(std::span<const HalfSums> sums, int end);

  [[nodiscard]] std::span<const PixelClass> classes() const { return classes_; }
  // Half the difference of the halves' means, squared.
  [[nodiscard]] float squaredDifference(std::size_t pixel) const;
  // The classes' scale by what all pixels tell together.
  [[nodiscard]] PictureScale scale(std::span<const HalfSums> sums, const Discoveries& discoveries) const;

 private:
  // What a pixel's own samples say.
  struct Statistics {
    glm::vec3 mean;
    float variance;    // of a sample
    float difference;  // half the difference of the halves' means, squared, times n^(3/2)
    int sampleStep;    // n is 2 to the power of it
  };

  [[nodiscard]] static Statistics statistics(const HalfSums& sums);
  [[nodiscard]] PixelClass classOf(int x, int y) const;
  [[nodiscard]] int usualRateStep(int x, int y, float variance) const;
  [[nodiscard]] int rateStepAround(int x, int y, int usualRateStep) const;
  void updateRows(std::span<const HalfSums> sums, int end, unsigned threads);
  void updateStatistics(std::span<const HalfSums> sums, int y);
  void updateClasses(int y);

  int width_;
  int height_;
  bool isStratified_;
  float negligible_;
  std::vector<std::uint8_t> isMarked_;
  std::vector<Statistics> statistics_;
  std::vector<PixelClass> classes_;
  int statisticsEnd_ = 0;  // these two: the rows before them are up to date
  int classesEnd_ = 0;
};

}  // namespace lavaray
