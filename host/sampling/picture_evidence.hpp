#pragma once

#include "sampling/discoveries.hpp"
#include "sampling/sample_allocation.hpp"

namespace lavaray {

// What the halves of many pixels' samples tell of the pixels' errors.
//
// Either half has the same squared error in the mean, and all samples have less: by half the difference of
// the halves' means, squared. So what a pixel's error falls by with a doubling is known without bias, and
// with the doubling before it by two of them. How much is left follows from the rate at which these
// differences fall.
class PictureEvidence {
 public:
  // formerDifference is 0 where none is known. Of pixels that are not suspected to have missed something.
  void add(PixelClass pixel, double squaredDifference, double formerDifference);
  void add(const PictureEvidence& other);

  // By sample step, what the classes' squared errors are to be multiplied by.
  [[nodiscard]] Discoveries::Sums scales() const;

 private:
  [[nodiscard]] double fall() const;

  using Sums = Discoveries::Sums;
  // By sample step: of the classes' squared errors, their squares, the differences where only the present one
  // is known, what is left of smooth pixels' errors there, and the differences, present and former, where
  // both are.
  Sums errors_{};
  Sums errorSquares_{};
  Sums single_{};
  Sums leftOfSmooth_{};
  Sums present_{};
  Sums former_{};
  double formerSquares_ = 0.0;
};

}  // namespace lavaray
