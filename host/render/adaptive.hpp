#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "film/film.hpp"
#include "interface.h"

namespace lavaray {

// Decides which pixels get more samples until the image's root-mean-square error is at most a target.
//
// Each pixel has two sequences of samples that are independent of one another, its halves. Half the
// difference of their means estimates the error of the mean of both, without a bias from the samples
// themselves. From one pixel that estimate is rough: so the differences of a pixel and its neighbours say how
// much the samples' stratification gains there, and the variance of the pixel's own samples says how hard it
// is; one that differs from a neighbour may have an edge that all its samples have missed. Samples go where
// one more lowers the error most: where the error of n samples falls with n^-3/4 (edges and penumbrae under a
// scrambled net: Mitchell, "Consequences of Stratified Sampling in Graphics", 1996), that makes n
// proportional to hardness^(2/5). Pure arithmetic: it traces nothing.
class AdaptiveSampling {
 public:
  // targetError > 0 is in units of a colour of 0..1; maxSamples >= 2 bounds the samples of a pixel. The
  // pixels of small objects get more samples to begin with (see pixelsOfSmallObjects).
  AdaptiveSampling(int width, int height, double targetError, std::uint32_t maxSamples,
                   std::vector<std::uint64_t> smallObjects);

  // The samples to take next; none where the target is reached or nothing more is allowed. All of them must
  // be added, in any order, before the next call.
  std::vector<gpu::WorkItem> nextItems();
  void add(const gpu::WorkItem& item, const gpu::WorkResult& result);

  // All that the plan goes by, to be kept and to be given back to a new plan for the same image.
  [[nodiscard]] std::span<const HalfSums> pixels() const { return pixels_; }
  void goOnWith(std::vector<HalfSums> pixels);

  [[nodiscard]] bool reachedTarget() const { return estimatedError_ <= goal_; }
  [[nodiscard]] double estimatedError() const { return estimatedError_; }  // RMSE over pixels and channels
  [[nodiscard]] double estimatedError(std::uint64_t pixel) const;
  // Of the whole render, by the present plan.
  [[nodiscard]] double plannedSamples() const { return plannedSamples_; }
  [[nodiscard]] glm::dvec3 mean(std::uint64_t pixel) const;
  [[nodiscard]] std::uint32_t samples(std::uint64_t pixel) const;

 private:
  // What a pixel's samples say, apart from its neighbours.
  struct Statistics {
    glm::vec3 mean;
    float difference;  // of the halves, squared, in units of hardness
    float variance;    // of a sample
  };
  // Hardness is quantised to steps of a factor 2^(1/4) and sample counts are powers of two, so that a plan
  // for a million pixels is one for a few hundred classes.
  struct Class {
    int hardnessStep;
    int sampleStep;
    double pixels;
  };

  [[nodiscard]] Statistics statistics(std::size_t pixel) const;
  [[nodiscard]] double stratification(int x, int y, const std::vector<Statistics>& statistics) const;
  [[nodiscard]] double hardness(int x, int y, const std::vector<Statistics>& statistics) const;
  [[nodiscard]] std::uint32_t largestHalfCount() const {
    return (1U << static_cast<unsigned>(maxSampleStep_)) / 2;
  }
  void estimateHardness();
  [[nodiscard]] std::vector<Class> classes() const;
  [[nodiscard]] int plannedStep(int hardnessStep, int sampleStep, double price) const;
  [[nodiscard]] double plannedVariance(const std::vector<Class>& classes, double price) const;
  [[nodiscard]] double choosePrice(const std::vector<Class>& classes) const;
  void appendFirstSamples(std::vector<gpu::WorkItem>& items) const;
  void appendSamples(std::vector<gpu::WorkItem>& items, std::size_t pixel, std::uint32_t halfCount) const;

  int width_;
  int height_;
  double goal_;
  int maxSampleStep_;
  std::uint32_t smallObjectHalfSamples_;
  double estimatedError_ = 1.0;
  double plannedSamples_ = 0.0;
  bool hasStarted_ = false;
  std::vector<HalfSums> pixels_;
  std::vector<std::uint64_t> smallObjects_;
  std::vector<std::uint8_t> hardnessSteps_;  // 0 is no error at all
};

}  // namespace lavaray
