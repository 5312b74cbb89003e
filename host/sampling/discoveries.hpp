#pragma once

#include <array>

#include "sampling/convergence.hpp"

namespace lavaray {

// How often samples miss something that a pixel shows, measured by what the next ones find there.
//
// Where a neighbour shows what a pixel's samples have not met, something may have been missed. How large the
// error then is in the mean, per unit of what is suspected (see ErrorEstimate), depends on the picture: edges
// of large objects end where they were met, while thin things and shadows come and go. When such a pixel
// gets as many samples again, half the difference of the halves, squared, is in the mean what the squared
// error falls by, whatever there is. So each doubling of a suspected pixel is a trial.
//
// Based on: Good, "The Population Frequencies of Species and the Estimation of Population Parameters", 1953.
class Discoveries {
 public:
  using Sums = std::array<double, convergence::kSampleSteps>;

  // A pixel of 2^sampleStep samples in which a squared error was suspected has got as many again.
  void add(int sampleStep, double suspected, double squaredDifference);

  // The mean squared error of pixels of 2^sampleStep samples, per unit of what is suspected there.
  [[nodiscard]] Sums shares() const;

  // For films: everything that was added.
  [[nodiscard]] std::array<Sums, 3> state() const { return {suspected_, squares_, found_}; }
  void restore(const std::array<Sums, 3>& state) {
    suspected_ = state[0];
    squares_ = state[1];
    found_ = state[2];
  }

 private:
  // By sample step: what was suspected, the squares of that, and what was found.
  Sums suspected_{};
  Sums squares_{};
  Sums found_{};
};

}  // namespace lavaray
