#include "sampling/adaptive_plan.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"

namespace lavaray {
namespace {

// In one pass a pixel's samples grow by at most this factor (log2): the first estimates are rough, and what
// its neighbours turn out to be may explain the difference from them.
constexpr int kMaxGrowth = 1;
// All samples of a render over those it begins with, as long as nothing is known of the image; for progress.
constexpr double kUsualGrowth = 4.0;
// Samples of a pixel to begin with.
constexpr std::uint32_t kFirstSamples = gpu::kMinSamplesPerItem;

// The same where there is an object that so few could miss; the lower the target, the more a missed one
// matters.
std::uint32_t smallObjectSamples(double targetError) {
  return std::bit_floor(static_cast<std::uint32_t>(std::clamp(0.08 / targetError, 2.0, 64.0)));
}

// Items are listed in bands of so many rows of pixels, one after the other, so that what the first bands tell
// can be worked out while others are traced.
constexpr int kBandRows = 16;
// As many items as this share of the pixels are listed before the first of them are traced: enough to trace
// while the rest is listed.
constexpr std::size_t kPassParts = 8;

// Aims lower than asked for, as much as the estimate may be too low: over 19 scenes, targets from 0.02 to
// 0.001 and several seeds, 97 % of the true errors are then at most the target.
constexpr double kGoalFactor = 0.87;
// What pixels tell is too little by these factors of the squared error: a pixel gets more samples where its
// differences are large, so in the mean the former ones are larger than those that follow, which makes them
// seem to fall faster than they do; and it stops where they are small. Where samples are few, they decide by
// themselves. Measured: the estimates of most of the scenes are then within a tenth of the true error, and no
// other constants of the same number came closer.
constexpr double kSelection = 1.44;
constexpr double kSelectionOfFew = 1.75;
constexpr std::size_t kFewSteps = 4;  // fewer than 16 samples
// What a pass leads to is known only roughly, so that one that aims at the goal often goes too far. While
// more than the second of these shares is left, a pass does no more than leave this one of it, up to a limit.
constexpr double kShareLeft = 1.0 / 3.0;
constexpr double kLeastExcess = 0.03;
constexpr double kMostExcess = 0.15;
// The last pass aims this share below the goal: several that each come a little closer cost more.
constexpr double kLastMargin = 0.005;
// A pixel whose error is below this many times the goal is not worth a better estimate.
constexpr double kNegligibleError = 0.1;

PictureScale withSelection(PictureScale scale) {
  for (std::size_t step = 0; step < scale.seen.size(); ++step)
    scale.seen[step] *= step < kFewSteps ? kSelectionOfFew : kSelection;
  return scale;
}

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
      bandPixels_(std::uint64_t{kBandRows} * static_cast<std::uint64_t>(size.width)),
      bands_((pixels_ + bandPixels_ - 1) / bandPixels_),
      smallObjects_(std::move(smallObjects)),
      isStratified_(goal.isStratified),
      estimate_(size.width, size.height, goal.isStratified,
                kNegligibleError * kNegligibleError * goal_ * goal_) {}

double AdaptivePlan::estimatedError(std::uint64_t pixel) const {
  return std::sqrt(scale_.squaredError(estimate_.classes()[pixel]));
}

void AdaptivePlan::resumeFrom(std::span<const HalfSums> sums, const Discoveries& discoveries) {
  hasStarted_ = true;
  discoveries_ = discoveries;
  estimate_.markAll();
  for (std::uint64_t pixel = 0; pixel < pixels_; ++pixel) {
    const HalfSums& ofPixel = sums[pixel];
    plannedSamples_ += kUsualGrowth * (ofPixel.halves[0].samples() + ofPixel.halves[1].samples());
    if (ofPixel.suspected > 0.0F) suspects_.push_back(pixel);
  }
}

// Calls work(band, its pixels) for bands that follow one another, on several threads.
template <typename Work>
void AdaptivePlan::forBands(std::size_t begin, std::size_t end, const Work& work) const {
  parallelFor(end - begin, hardwareThreads(), [&](std::size_t i) {
    const std::uint64_t band = begin + i;
    work(band, PixelRange{band * bandPixels_, std::min((band + 1) * bandPixels_, pixels_)});
  });
}

// Appends the items of the bands before `end` that are not listed yet. visitItems(pixels, visit) calls
// visit(item) for each item of a band: first to count them, then to list them.
template <typename VisitItems>
void AdaptivePlan::list(std::size_t end, const VisitItems& visitItems, WorkList& items) {
  const std::size_t begin = bandEnds_.size();
  std::vector<std::uint64_t> starts(end - begin);
  forBands(begin, end, [&](std::size_t band, const PixelRange& pixels) {
    visitItems(pixels, [&](const gpu::WorkItem&) { ++starts[band - begin]; });
  });
  std::uint64_t count = items.size();
  for (std::uint64_t& start : starts) {
    const std::uint64_t ofBand = start;
    start = count;
    count += ofBand;
    bandEnds_.push_back(count);
  }
  items.resize(count);
  forBands(begin, end, [&](std::size_t band, const PixelRange& pixels) {
    auto next = items.begin() + static_cast<std::ptrdiff_t>(starts[band - begin]);
    visitItems(pixels, [&](const gpu::WorkItem& item) { *next++ = item; });
  });
}

void AdaptivePlan::listFirst(WorkList& items) {
  const auto visitItems = [&](const PixelRange& pixels, const auto& visit) {
    for (std::uint64_t pixel = pixels.begin; pixel < pixels.end; ++pixel)
      forEachItem(pixel, 0, kFirstSamples, visit);
    auto small = std::ranges::lower_bound(smallObjects_, pixels.begin);
    for (; small != smallObjects_.end() && *small < pixels.end; ++small)
      forEachItem(*small, kFirstSamples, smallObjectSamples_, visit);
  };
  list(bands_, visitItems, items);
}

// Within a band items of one size follow one another, since a device traces neighbours together and waits for
// the largest.
void AdaptivePlan::listGrowth(std::size_t end, std::span<HalfSums> sums, WorkList& items) {
  static_assert(gpu::kMaxSamplesPerItem == 2 * kFirstSamples && kMaxGrowth == 1);  // so there are two sizes
  const std::span<const PixelClass> classes = estimate_.classes();
  const auto visitItems = [&](const PixelRange& pixels, const auto& visit) {
    std::vector<std::uint64_t> ofSmallItems;
    for (std::uint64_t pixel = pixels.begin; pixel < pixels.end; ++pixel) {
      if (allocation_->growth(classes[pixel]) == 0) continue;
      const std::uint32_t samples = 1U << static_cast<unsigned>(classes[pixel].sampleStep());
      if (samples < gpu::kMaxSamplesPerItem) {
        ofSmallItems.push_back(pixel);
      } else {
        forEachItem(pixel, samples, 2 * samples, visit);
      }
    }
    for (const std::uint64_t pixel : ofSmallItems)
      forEachItem(pixel, kFirstSamples, 2 * kFirstSamples, visit);
  };
  const std::size_t begin = bandEnds_.size();
  list(end, visitItems, items);
  std::vector<std::vector<std::uint64_t>> suspects(end - begin);
  forBands(begin, end, [&](std::size_t band, const PixelRange& pixels) {
    for (std::uint64_t pixel = pixels.begin; pixel < pixels.end; ++pixel) {
      if (allocation_->growth(classes[pixel]) == 0) continue;
      const bool isSuspected = classes[pixel].isSuspected();
      if (isSuspected) suspects[band - begin].push_back(pixel);
      sums[pixel].suspected = isSuspected ? static_cast<float>(classes[pixel].squaredError()) : 0.0F;
      sums[pixel].formerDifference = isSuspected ? 0.0F : estimate_.squaredDifference(pixel);
      sums[pixel].halves[0].add(sums[pixel].halves[1]);
      sums[pixel].halves[1] = {};
      estimate_.mark(pixel);
    }
  });
  for (const auto& ofBand : suspects) suspects_.insert(suspects_.end(), ofBand.begin(), ofBand.end());
  if (end == bands_) allocation_.reset();
}

void AdaptivePlan::listRest(SamplePass& pass, std::span<HalfSums> sums) {
  if (!allocation_) return;
  listGrowth(bands_, sums, pass.list);
  pass.items = pass.list.size();
}

void AdaptivePlan::advance(std::uint64_t items, std::span<const HalfSums> sums) {
  const auto done = static_cast<std::size_t>(std::ranges::upper_bound(bandEnds_, items) - bandEnds_.begin());
  if (done < bandEnds_.size()) estimate_.updateRows(sums, static_cast<int>(done) * kBandRows);
}

// In the order of the pixels, as sums of doubles depend on it.
void AdaptivePlan::takeDiscoveries(std::span<HalfSums> sums) {
  const std::span<const PixelClass> classes = estimate_.classes();
  for (const std::uint64_t pixel : suspects_) {
    if (sums[pixel].suspected == 0.0F) continue;
    discoveries_.add(classes[pixel].sampleStep() - 1, double{sums[pixel].suspected},
                     double{estimate_.squaredDifference(pixel)});
    sums[pixel].suspected = 0.0F;
  }
  suspects_.clear();
}

SamplePass AdaptivePlan::nextPass(std::span<HalfSums> sums) {
  SamplePass pass = beginPass(sums);
  listRest(pass, sums);
  return pass;
}

SamplePass AdaptivePlan::beginPass(std::span<HalfSums> sums, WorkList items) {
  items.clear();
  bandEnds_.clear();
  if (!hasStarted_) {
    hasStarted_ = true;
    estimate_.markAll();
    listFirst(items);
    for (const gpu::WorkItem& item : items) plannedSamples_ += kUsualGrowth * item.count;
    return listedPass(std::move(items));
  }
  estimate_.update(sums);
  takeDiscoveries(sums);
  scale_ = estimate_.scale(sums, discoveries_);
  if (isStratified_) scale_ = withSelection(scale_);
  allocation_.emplace(estimate_.classes(), scale_, goal_ * goal_, maxSampleStep_);
  estimatedError_ = std::sqrt(allocation_->squaredError());
  plannedSamples_ = allocation_->samples();
  if (reachedTarget()) {
    allocation_.reset();
    return {};
  }
  const double excess = estimatedError_ / goal_ - 1.0;
  const double aim =
      excess > kLeastExcess ? 1.0 + std::min(kShareLeft * excess, kMostExcess) : 1.0 - kLastMargin;
  allocation_.emplace(estimate_.classes(), scale_, aim * aim * goal_ * goal_, maxSampleStep_);
  while (items.size() <= pixels_ / kPassParts && allocation_)
    listGrowth(std::min(bandEnds_.size() + 1 + bands_ / kPassParts, bands_), sums, items);
  return listedPass(std::move(items));
}

}  // namespace lavaray
