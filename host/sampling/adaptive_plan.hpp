#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/rectangle.hpp"
#include "sampling/error_estimate.hpp"
#include "sampling/sample_allocation.hpp"
#include "sampling/sample_pass.hpp"

namespace lavaray {

struct AdaptiveGoal {
  double targetError;  // > 0: of the image's RMSE over pixels and channels, in units of a colour of 0..1
  std::uint32_t maxSamples;  // of a pixel, >= 2
  bool isStratified;         // whether the samples of a pixel are, or are independent
};

// Decides which pixels get more samples until the image's root-mean-square error is at most a target.
//
// A pixel's samples are one stratified sequence, of which it has a power of two, so that its halves tell its
// error (see ErrorEstimate). Samples go where one more lowers the error most (see SampleAllocation). This is
// pure arithmetic: nothing is traced, and the sums of the samples are the caller's.
class AdaptivePlan {
 public:
  // The pixels of small objects, numbered row by row, get more samples to begin with.
  AdaptivePlan(const ImageSize& size, const AdaptiveGoal& goal, std::vector<std::uint64_t> smallObjects);

  // Of memory, including the work items of a pass and of the next one, whose vector grows.
  static std::size_t bytesPerPixel() { return ErrorEstimate::bytesPerPixel() + 4 * sizeof(gpu::WorkItem); }

  // The samples to take next; none once the target is reached or nothing more is allowed. All results of the
  // pass before must be in `sums`. The halves of pixels that get more are added up there: what they have so
  // far becomes the first half.
  SamplePass nextPass(std::span<HalfSums> sums);
  // The same in two steps, of which the second one can be done while items of the first are traced: the first
  // items of the pass, none where it has none, and the rest, if there is any.
  // `items` is an older list, of no other use than its memory.
  SamplePass beginPass(std::span<HalfSums> sums, WorkList items = {});
  void listRest(SamplePass& pass, std::span<HalfSums> sums);

  // Says that the results of that many of the pass's items, in their order, are in `sums`. What they tell of
  // the error is then worked out at once, while others are traced, instead of by the next call of nextPass().
  void advance(std::uint64_t items, std::span<const HalfSums> sums);

  // Goes on from the sums of an earlier plan for the same image, and from what it had found.
  void resumeFrom(std::span<const HalfSums> sums, const Discoveries& discoveries);
  [[nodiscard]] const Discoveries& discoveries() const { return discoveries_; }

  [[nodiscard]] bool reachedTarget() const { return estimatedError_ <= goal_; }
  [[nodiscard]] double estimatedError() const { return estimatedError_; }  // RMSE over pixels and channels
  [[nodiscard]] double estimatedError(std::uint64_t pixel) const;
  // Of the whole render, as far as can be told now.
  [[nodiscard]] double plannedSamples() const { return plannedSamples_; }

 private:
  struct PixelRange {
    std::uint64_t begin;
    std::uint64_t end;
  };

  template <typename Work>
  void forBands(std::size_t begin, std::size_t end, const Work& work) const;
  template <typename VisitItems>
  void list(std::size_t end, const VisitItems& visitItems, WorkList& items);
  void takeDiscoveries(std::span<HalfSums> sums);
  void listFirst(WorkList& items);
  void listGrowth(std::size_t end, std::span<HalfSums> sums, WorkList& items);

  double goal_;
  int maxSampleStep_;
  std::uint32_t smallObjectSamples_;
  double estimatedError_ = 1.0;
  double plannedSamples_ = 0.0;
  bool hasStarted_ = false;
  std::uint64_t pixels_;
  std::uint64_t bandPixels_;
  std::size_t bands_;
  // Items of the pass up to the end of each band that is listed; empty where the pass was not planned here.
  std::vector<std::uint64_t> bandEnds_;
  std::optional<SampleAllocation> allocation_;  // as long as bands are left to list
  std::vector<std::uint64_t> smallObjects_;
  bool isStratified_;
  std::vector<std::uint64_t> suspects_;  // of the pass, in the order of the pixels
  Discoveries discoveries_;
  PictureScale scale_{};
  ErrorEstimate estimate_;
};

}  // namespace lavaray
