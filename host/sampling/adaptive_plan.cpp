#include "sampling/adaptive_plan.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace lavaray {
namespace {

// In one pass a pixel's samples grow by at most this factor (log2): the first estimates are rough, and what
// its neighbours turn out to be may explain the difference from them.
constexpr int kMaxGrowth = 1;
// All samples of a render over those it begins with, as long as nothing is known of the image; for progress.
constexpr double kUsualGrowth = 4.0;
// Samples of a pixel to begin with.
constexpr std::uint32_t kFirstSamples = 2;

// The same where there is an object that so few could miss; the lower the target, the more a missed one
// matters.
std::uint32_t smallObjectSamples(double targetError) {
  return std::bit_floor(static_cast<std::uint32_t>(std::clamp(0.08 / targetError, 2.0, 64.0)));
}

// Aims lower than asked for: pixels that look too easy by chance are not looked at again, and the error of
// narrow penumbrae converges ever more slowly, which makes the estimate up to 18 % too low.
constexpr double kGoalFactor = 0.85;
// A pixel whose error is below this many times the goal is not worth a better estimate.
constexpr double kNegligibleError = 0.1;

int sampleStepOf(std::uint32_t samples) {
  return static_cast<int>(std::bit_width(samples)) - 1;
}

// The items with which a pixel's samples grow from one power of two to another. They end at powers of two up
// to the largest size and at multiples of it, wherever a pass ends: so samples are always summed in the same
// groups, and the image does not depend on the passes that took them.
template <typename Visit>
void forEachItem(std::size_t pixel, std::uint32_t from, std::uint32_t to, const Visit& visit) {
  for (std::uint32_t first = from; first < to;) {
    const std::uint32_t count = std::clamp(first, kFirstSamples, gpu::kMaxSamplesPerItem);
    const bool isInFirstHalf = first < std::max(to / 2, kFirstSamples);
    visit(gpu::WorkItem{static_cast<gpu::uint>(pixel), isInFirstHalf ? 0U : 1U, first, count});
    first += count;
  }
}

}  // namespace

AdaptivePlan::AdaptivePlan(const ImageSize& size, const AdaptiveGoal& goal,
                           std::vector<std::uint64_t> smallObjects)
    : goal_(kGoalFactor * goal.targetError),
      maxSampleStep_(std::min(sampleStepOf(goal.maxSamples), convergence::kSampleSteps - 1)),
      smallObjectSamples_(std::min(smallObjectSamples(goal.targetError), std::bit_floor(goal.maxSamples))),
      pixels_(static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height)),
      smallObjects_(std::move(smallObjects)),
      estimate_(size.width, size.height, goal.isStratified,
                kNegligibleError * kNegligibleError * goal_ * goal_) {}

double AdaptivePlan::estimatedError(std::uint64_t pixel) const {
  return std::sqrt(estimate_.classes()[pixel].squaredError());
}

void AdaptivePlan::resumeFrom(std::span<const HalfSums> sums) {
  hasStarted_ = true;
  estimate_.markAll();
  for (const HalfSums& pixel : sums)
    plannedSamples_ += kUsualGrowth * (pixel.halves[0].samples() + pixel.halves[1].samples());
}

std::vector<gpu::WorkItem> AdaptivePlan::firstItems() const {
  std::vector<gpu::WorkItem> items;
  items.reserve(pixels_);
  for (std::uint64_t pixel = 0; pixel < pixels_; ++pixel)
    forEachItem(pixel, 0, kFirstSamples, [&](const gpu::WorkItem& item) { items.push_back(item); });
  for (const std::uint64_t pixel : smallObjects_) {
    forEachItem(pixel, kFirstSamples, smallObjectSamples_,
                [&](const gpu::WorkItem& item) { items.push_back(item); });
  }
  return items;
}

// Items of one size follow one another, since a device traces neighbours together and waits for the largest.
std::vector<gpu::WorkItem> AdaptivePlan::itemsOf(const SampleAllocation& allocation,
                                                 std::span<HalfSums> sums) {
  std::vector<gpu::WorkItem> items;
  const std::span<const PixelClass> classes = estimate_.classes();
  const auto grown = [&](std::size_t pixel) {
    return 1U << static_cast<unsigned>(classes[pixel].sampleStep() +
                                       std::min(allocation.growth(classes[pixel]), kMaxGrowth));
  };
  for (std::uint32_t size = gpu::kMaxSamplesPerItem; size >= kFirstSamples; size /= 2) {
    for (std::size_t pixel = 0; pixel < sums.size(); ++pixel) {
      forEachItem(pixel, 1U << static_cast<unsigned>(classes[pixel].sampleStep()), grown(pixel),
                  [&](const gpu::WorkItem& item) {
                    if (item.count == size) items.push_back(item);
                  });
    }
  }
  for (std::size_t pixel = 0; pixel < sums.size(); ++pixel) {
    if (allocation.growth(classes[pixel]) == 0) continue;
    sums[pixel].halves[0].add(sums[pixel].halves[1]);
    sums[pixel].halves[1] = {};
    estimate_.mark(pixel);
  }
  return items;
}

SamplePass AdaptivePlan::nextPass(std::span<HalfSums> sums) {
  if (!hasStarted_) {
    hasStarted_ = true;
    estimate_.markAll();
    std::vector<gpu::WorkItem> items = firstItems();
    for (const gpu::WorkItem& item : items) plannedSamples_ += kUsualGrowth * item.count;
    return listedPass(std::move(items));
  }
  estimate_.update(sums);
  const SampleAllocation allocation(estimate_.classes(), goal_ * goal_, maxSampleStep_);
  estimatedError_ = std::sqrt(allocation.squaredError());
  plannedSamples_ = allocation.samples();
  return reachedTarget() ? SamplePass{} : listedPass(itemsOf(allocation, sums));
}

}  // namespace lavaray
