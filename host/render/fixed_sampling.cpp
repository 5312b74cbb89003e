#include "render/fixed_sampling.hpp"

#include <algorithm>
#include <cassert>
#include <span>

namespace lavaray {
namespace {

// The first rounds are smaller: a pixel without a sample is black.
constexpr std::uint32_t kRoundSamples = 64;

std::uint32_t itemsFor(std::uint32_t samples) {
  return (samples + gpu::kMaxSamplesPerItem - 1) / gpu::kMaxSamplesPerItem;
}

}  // namespace

FixedSampling::FixedSampling(std::uint64_t pixels, SampleRange range, View view)
    : Sampling(pixels), range_(range), view_(view), roundFirst_(range.first), sums_(pixels) {
  if (isMeasure(view)) measured_.resize(pixels);
}

std::uint64_t FixedSampling::mostItems(std::uint64_t pixels, SampleRange range) {
  return pixels * itemsFor(std::min(range.end - range.first, kRoundSamples));
}

void FixedSampling::startRound(std::uint32_t first, std::uint32_t size) {
  roundFirst_ = first;
  roundSize_ = size;
  roundItems_ = itemsFor(size);
}

std::uint64_t FixedSampling::planPass() {
  const std::uint32_t first = roundFirst_ + roundSize_;
  const std::uint32_t usual = std::clamp(first - range_.first, gpu::kMaxSamplesPerItem, kRoundSamples);
  startRound(first, std::min(usual, range_.end - first));
  return sums_.size() * roundItems_;
}

void FixedSampling::describe(FilmHeader& header) const {
  assert(measured_.empty());  // films are of colours
  header.kind = FilmKind::kFixed;
  header.roundFirst = roundFirst_;
  header.roundSize = roundSize_;
  header.itemsDone = itemsDone();
}

void FixedSampling::write(FilmWriter& film) const {
  film.write(std::as_bytes(std::span(sums_)));
}

void FixedSampling::read(FilmReader& film) {
  film.readPixels(std::as_writable_bytes(std::span(sums_)));
  startRound(film.header().roundFirst, film.header().roundSize);
  goOnAt(film.header().itemsDone, sums_.size() * roundItems_);
}

gpu::WorkItem FixedSampling::item(std::uint64_t index) const {
  const auto offset = static_cast<std::uint32_t>(index % roundItems_) * gpu::kMaxSamplesPerItem;
  return {static_cast<gpu::uint>(index / roundItems_), 0, roundFirst_ + offset,
          std::min(gpu::kMaxSamplesPerItem, roundSize_ - offset)};
}

void FixedSampling::makeItems(std::uint64_t first, std::span<gpu::WorkItem> items) const {
  for (gpu::WorkItem& next : items) next = item(first++);
}

void FixedSampling::take(std::uint64_t first, std::span<const gpu::WorkResult> results) {
  for (const gpu::WorkResult& result : results) {
    const gpu::WorkItem done = item(first++);
    if (!measured_.empty()) measured_[done.pixel] += glm::dvec3(result.sum);
    sums_[done.pixel].add(measured_.empty() ? result.sum : glm::vec3(0.0F), done.count);
  }
}

void FixedSampling::copyValues(std::uint64_t first, std::span<glm::vec3> values) const {
  for (glm::vec3& value : values) {
    value = measured_.empty() ? glm::vec3(sums_[first].mean()) : glm::vec3(measuredValue(first));
    ++first;
  }
}

float FixedSampling::measuredValue(std::uint64_t pixel) const {
  return static_cast<float>(measure(view_, measured_[pixel], samples(pixel)));
}

std::uint32_t FixedSampling::mostSamples() const {
  std::uint32_t most = 0;
  for (const PixelSum& sum : sums_) most = std::max(most, sum.samples());
  return most;
}

double FixedSampling::shareDone() const {
  const double round = passItems() == 0
                           ? 0.0
                           : roundSize_ * static_cast<double>(itemsDone()) / static_cast<double>(passItems());
  return (roundFirst_ - range_.first + round) / (range_.end - range_.first);
}

}  // namespace lavaray
