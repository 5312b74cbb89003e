#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "interface.h"
#include "render/pixel_sum.hpp"

namespace lavaray {

// Decides which pixels get more samples until the image's root-mean-square error is at most a target.
//
// Each pixel has two sequences of samples that are independent of one another, its halves. Half the
// difference of their means estimates the error of the mean of both, without a bias from the samples
// themselves; pooled over a pixel and its neighbours it says how hard a pixel is; one that differs from a
// neighbour may have an edge that all its samples have missed. Samples go where one more lowers the error
// most: where the error of n samples falls with n^-3/4 (edges and penumbrae under a scrambled net: Mitchell,
// "Consequences of Stratified Sampling in Graphics", 1996), that makes n proportional to hardness^(2/5). Pure
// arithmetic: it traces nothing.
class AdaptiveSampling {
 public:
  // targetError > 0 is in units of a colour of 0..1; maxSamples >= 2 bounds the samples of a pixel. The
  // pixels of small objects get more samples to begin with (see pixelsOfSmallObjects).
  AdaptiveSampling(int width, int height, double targetError, std::uint32_t maxSamples,
                   std::vector<std::uint64_t> smallObjects);

  // The samples to take next; none where the target is reached or nothing more is allowed. All of them must
  // be added before the next call.
  std::vector<gpu::WorkItem> nextItems();
  void add(const gpu::WorkItem& item, const glm::vec3& sum);

  [[nodiscard]] bool reachedTarget() const { return estimatedError_ <= goal_; }
  [[nodiscard]] double estimatedError() const { return estimatedError_; }  // RMSE over pixels and channels
  [[nodiscard]] double estimatedError(std::uint64_t pixel) const;
  [[nodiscard]] glm::dvec3 mean(std::uint64_t pixel) const;
  [[nodiscard]] std::uint32_t samples(std::uint64_t pixel) const;

 private:
  // Hardness is quantised to steps of a factor 2^(1/4) and sample counts are powers of two, so that a plan
  // for a million pixels is one for a few hundred classes.
  static constexpr int kHardnessSteps = 256;
  static constexpr int kSampleSteps = 24;
  using Histogram = std::array<std::array<std::uint32_t, kSampleSteps>, kHardnessSteps>;

  [[nodiscard]] double difference(std::size_t pixel) const;
  [[nodiscard]] static double unseenEdge(double squaredContrast, std::uint32_t samples);
  [[nodiscard]] std::uint32_t largestHalfCount() const {
    return (1U << static_cast<unsigned>(maxSampleStep_)) / 2;
  }
  void estimateHardness();
  [[nodiscard]] Histogram histogram() const;
  [[nodiscard]] int plannedStep(int hardnessStep, int sampleStep, double price) const;
  [[nodiscard]] double plannedVariance(const Histogram& histogram, double price) const;
  [[nodiscard]] double choosePrice(const Histogram& histogram) const;
  void appendSamples(std::vector<gpu::WorkItem>& items, std::size_t pixel, std::uint32_t halfCount) const;

  int width_;
  int height_;
  double goal_;
  std::uint32_t firstHalfSamples_;
  int maxSampleStep_;
  double estimatedError_ = 1.0;
  bool hasStarted_ = false;
  std::vector<std::array<PixelSum, 2>> halves_;
  std::vector<std::uint64_t> smallObjects_;
  std::vector<std::uint8_t> hardnessSteps_;  // 0 is no error at all
};

}  // namespace lavaray
