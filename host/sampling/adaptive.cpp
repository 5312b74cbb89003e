#include "sampling/adaptive.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

namespace lavaray {
namespace {

// In one pass a pixel's samples grow at most by this factor, as the first estimates are rough, and its
// neighbours may come to explain what it differs in; log2.
constexpr int kLargestGrowth = 1;
// All samples of a render over those it begins with, as long as nothing is known of the image; for the
// progress.
constexpr double kUsualGrowth = 4.0;
// Samples of a pixel to begin with.
constexpr std::uint32_t kFirstSamples = 2;

// The same where an object falls that so few can miss; the lower the target, the more a missed one matters.
std::uint32_t smallObjectSamples(double targetError) {
  return std::bit_floor(static_cast<std::uint32_t>(std::clamp(0.08 / targetError, 2.0, 64.0)));
}

// Aims lower than asked for: pixels that look too easy by chance are not looked at again, and the error of
// narrow penumbrae falls the slower the lower it is, which makes the estimate up to 18 % too low.
constexpr double kGoalFactor = 0.85;
// A pixel with an error of so many times the goal is not worth a better estimate.
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

AdaptiveSampling::AdaptiveSampling(int width, int height, double targetError, std::uint32_t maxSamples,
                                   bool isStratified, std::vector<std::uint64_t> smallObjects)
    : goal_(kGoalFactor * targetError),
      maxSampleStep_(std::min(sampleStepOf(maxSamples), convergence::kSampleSteps - 1)),
      smallObjectSamples_(std::min(smallObjectSamples(targetError), std::bit_floor(maxSamples))),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      smallObjects_(std::move(smallObjects)),
      estimate_(width, height, isStratified, kNegligibleError * kNegligibleError * goal_ * goal_) {}

glm::dvec3 AdaptiveSampling::mean(std::uint64_t pixel) const {
  PixelSum sum = pixels_[pixel].halves[0];
  sum.add(pixels_[pixel].halves[1]);
  return sum.mean();
}

std::uint32_t AdaptiveSampling::samples(std::uint64_t pixel) const {
  return pixels_[pixel].halves[0].samples() + pixels_[pixel].halves[1].samples();
}

double AdaptiveSampling::estimatedError(std::uint64_t pixel) const {
  return std::sqrt(estimate_.classes()[pixel].squaredError());
}

void AdaptiveSampling::add(const gpu::WorkItem& item, const gpu::WorkResult& result) {
  pixels_[item.pixel].halves[item.part].add(result.sum, item.count);
  pixels_[item.pixel].squares += PixelSum::toFixedPoint(result.squares);
}

void AdaptiveSampling::goOnWith(std::vector<HalfSums> pixels) {
  assert(pixels.size() == pixels_.size());
  pixels_ = std::move(pixels);
  hasStarted_ = true;
  estimate_.markAll();
  for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel)
    plannedSamples_ += kUsualGrowth * samples(pixel);
}

std::vector<gpu::WorkItem> AdaptiveSampling::firstItems() const {
  std::vector<gpu::WorkItem> items;
  items.reserve(pixels_.size());
  for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel)
    forEachItem(pixel, 0, kFirstSamples, [&](const gpu::WorkItem& item) { items.push_back(item); });
  for (const std::uint64_t pixel : smallObjects_) {
    forEachItem(pixel, kFirstSamples, smallObjectSamples_,
                [&](const gpu::WorkItem& item) { items.push_back(item); });
  }
  return items;
}

// Items of one size follow one another, since a device traces neighbours together and waits for the largest.
std::vector<gpu::WorkItem> AdaptiveSampling::itemsOf(const SamplePlan& plan) {
  std::vector<gpu::WorkItem> items;
  const std::span<const PixelClass> classes = estimate_.classes();
  const auto grown = [&](std::size_t pixel) {
    return 1U << static_cast<unsigned>(classes[pixel].sampleStep() +
                                       std::min(plan.growth(classes[pixel]), kLargestGrowth));
  };
  for (std::uint32_t size = gpu::kMaxSamplesPerItem; size >= kFirstSamples; size /= 2) {
    for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel) {
      forEachItem(pixel, 1U << static_cast<unsigned>(classes[pixel].sampleStep()), grown(pixel),
                  [&](const gpu::WorkItem& item) {
                    if (item.count == size) items.push_back(item);
                  });
    }
  }
  for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel) {
    if (plan.growth(classes[pixel]) == 0) continue;
    HalfSums& sums = pixels_[pixel];
    sums.halves[0].add(sums.halves[1]);
    sums.halves[1] = {};
    estimate_.mark(pixel);
  }
  return items;
}

std::vector<gpu::WorkItem> AdaptiveSampling::nextItems() {
  if (!hasStarted_) {
    hasStarted_ = true;
    estimate_.markAll();
    std::vector<gpu::WorkItem> items = firstItems();
    for (const gpu::WorkItem& item : items) plannedSamples_ += kUsualGrowth * item.count;
    return items;
  }
  estimate_.update(pixels_);
  const SamplePlan plan(estimate_.classes(), goal_ * goal_, maxSampleStep_);
  estimatedError_ = std::sqrt(plan.squaredError());
  plannedSamples_ = plan.samples();
  return reachedTarget() ? std::vector<gpu::WorkItem>() : itemsOf(plan);
}

}  // namespace lavaray
