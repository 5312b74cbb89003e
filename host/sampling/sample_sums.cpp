#include "sampling/sample_sums.hpp"

#include <algorithm>
#include <cassert>

#include "base/huge_pages.hpp"

namespace lavaray {
namespace {

PixelSum both(const HalfSums& sums) {
  PixelSum sum = sums.halves[0];
  sum.add(sums.halves[1]);
  return sum;
}

}  // namespace

std::size_t bytesPerPixel(SumKind kind) {
  switch (kind) {
    case SumKind::kCenter:
      return sizeof(glm::vec3);
    case SumKind::kMean:
      return sizeof(PixelSum);
    case SumKind::kHalves:
      return sizeof(HalfSums);
    case SumKind::kMeasure:
      return sizeof(MeasureSum);
    case SumKind::kNone:
      break;
  }
  return 0;
}

SampleSums::SampleSums(SumKind kind, std::uint64_t pixels) : kind_(kind), pixels_(pixels) {
  if (kind == SumKind::kCenter) {
    centers_.reserve(3 * pixels);
    preferHugePages(centers_.data(), centers_.capacity() * sizeof(float));
    centers_.resize(3 * pixels);
  }
  if (kind == SumKind::kMean) means_.resize(pixels);
  if (kind == SumKind::kHalves) halves_.resize(pixels);
  if (kind == SumKind::kMeasure) measures_.resize(pixels);
}

void SampleSums::add(const SamplePass& pass, std::uint64_t first, std::span<const gpu::WorkResult> results) {
  if (kind_ == SumKind::kCenter || kind_ == SumKind::kNone) {
    addCenters(results);
    return;
  }
  if (results.empty()) return;
  ItemCursor cursor(pass, first);
  for (const gpu::WorkResult& result : results) {
    const gpu::WorkItem item = cursor.next();
    samples_ += item.count;
    if (kind_ == SumKind::kMean) {
      means_[item.pixel].add(result.sum, item.count);
    } else if (kind_ == SumKind::kHalves) {
      halves_[item.pixel].halves[item.part].add(result.sum, item.count);
      halves_[item.pixel].squares += PixelSum::toFixedPoint(result.squares);
    } else {
      measures_[item.pixel].sum += glm::dvec3(result.sum);
      measures_[item.pixel].samples += item.count;
    }
  }
}

void SampleSums::addCenters(std::span<const gpu::WorkResult> results) {
  if (kind_ == SumKind::kCenter) {
    float* value = &centers_[3 * samples_];
    for (const gpu::WorkResult& result : results) value = std::copy_n(&result.sum.x, 3, value);
  }
  samples_ += results.size();
}

std::uint32_t SampleSums::samples(std::uint64_t pixel) const {
  switch (kind_) {
    case SumKind::kMean:
      return means_[pixel].samples();
    case SumKind::kHalves:
      return both(halves_[pixel]).samples();
    case SumKind::kMeasure:
      return measures_[pixel].samples;
    case SumKind::kCenter:
    case SumKind::kNone:
      break;
  }
  return pixel < samples_ ? 1 : 0;
}

std::uint32_t SampleSums::maxSamples() const {
  if (kind_ == SumKind::kCenter || kind_ == SumKind::kNone) return 1;
  std::uint32_t max = 0;
  for (std::uint64_t pixel = 0; pixel < pixels_; ++pixel) max = std::max(max, samples(pixel));
  return max;
}

void SampleSums::copyMeans(std::uint64_t first, std::span<glm::vec3> means) const {
  assert(first + means.size() <= pixels_);
  assert(kind_ == SumKind::kCenter || kind_ == SumKind::kMean || kind_ == SumKind::kHalves);
  if (kind_ == SumKind::kCenter) {
    std::copy_n(&centers_[3 * first], 3 * means.size(), &means.front().x);
  } else if (kind_ == SumKind::kMean) {
    for (glm::vec3& mean : means) mean = means_[first++].mean();
  } else {
    for (glm::vec3& mean : means) mean = both(halves_[first++]).mean();
  }
}

glm::dvec3 SampleSums::sum(std::uint64_t pixel) const {
  if (kind_ == SumKind::kMeasure) return measures_[pixel].sum;
  assert(kind_ == SumKind::kCenter);
  return {centers_[3 * pixel], centers_[3 * pixel + 1], centers_[3 * pixel + 2]};
}

std::span<const std::byte> SampleSums::bytes() const {
  if (kind_ == SumKind::kCenter) return std::as_bytes(std::span(centers_));
  if (kind_ == SumKind::kMean) return std::as_bytes(std::span(means_));
  assert(kind_ == SumKind::kHalves);
  return std::as_bytes(std::span(halves_));
}

std::span<std::byte> SampleSums::bytes() {
  if (kind_ == SumKind::kCenter) return std::as_writable_bytes(std::span(centers_));
  if (kind_ == SumKind::kMean) return std::as_writable_bytes(std::span(means_));
  assert(kind_ == SumKind::kHalves);
  return std::as_writable_bytes(std::span(halves_));
}

void SampleSums::restored(std::uint64_t centers) {
  samples_ = centers;
  if (kind_ == SumKind::kCenter) return;
  samples_ = 0;
  for (std::uint64_t pixel = 0; pixel < pixels_; ++pixel) samples_ += samples(pixel);
}

}  // namespace lavaray
