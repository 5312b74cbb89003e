#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "interface.h"
#include "sampling/error_estimate.hpp"
#include "sampling/pixel_sum.hpp"

namespace lavaray {

// Decides which pixels get more samples until the image's root-mean-square error is at most a target.
//
// A pixel's samples are one stratified sequence, of which it has a power of two, so that its halves tell its
// error (see ErrorEstimate). Samples go where one more lowers the error most (see SamplePlan). Pure
// arithmetic: it traces nothing.
class AdaptiveSampling {
 public:
  // targetError > 0 is in units of a colour of 0..1; maxSamples >= 2 bounds the samples of a pixel, which are
  // stratified or independent. The pixels of small objects get more samples to begin with (see
  // pixelsOfSmallObjects).
  AdaptiveSampling(int width, int height, double targetError, std::uint32_t maxSamples, bool isStratified,
                   std::vector<std::uint64_t> smallObjects);

  // Of memory, the items of a pass and those of the next, whose vector grows, included.
  static std::size_t bytesPerPixel() {
    return sizeof(HalfSums) + ErrorEstimate::bytesPerPixel() + 4 * sizeof(gpu::WorkItem);
  }

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
  [[nodiscard]] std::vector<gpu::WorkItem> firstItems() const;
  std::vector<gpu::WorkItem> itemsOf(const SamplePlan& plan);

  double goal_;
  int maxSampleStep_;
  std::uint32_t smallObjectSamples_;
  double estimatedError_ = 1.0;
  double plannedSamples_ = 0.0;
  bool hasStarted_ = false;
  std::vector<HalfSums> pixels_;
  std::vector<std::uint64_t> smallObjects_;
  ErrorEstimate estimate_;
};

}  // namespace lavaray
