#include "sampling/sample_pass.hpp"

#include <algorithm>
#include <utility>

namespace lavaray {
namespace {

// The first passes are shorter, since a pixel without a sample is black.
constexpr std::uint32_t kPassSamples = 64;

std::uint32_t itemsFor(SampleRange samples) {
  return (samples.end - samples.first + gpu::kMaxSamplesPerItem - 1) / gpu::kMaxSamplesPerItem;
}

}  // namespace

SamplePass uniformPass(std::uint64_t pixels, SampleRange samples) {
  return {pixels * itemsFor(samples), samples, {}};
}

SamplePass listedPass(WorkList list) {
  const std::uint64_t items = list.size();
  return {items, {0, 0}, std::move(list)};
}

SamplePass nextUniformPass(std::uint64_t pixels, SampleRange range, SampleRange before) {
  const std::uint32_t usual = std::clamp(before.end - range.first, gpu::kMaxSamplesPerItem, kPassSamples);
  return uniformPass(pixels, {before.end, before.end + std::min(usual, range.end - before.end)});
}

std::uint64_t maxUniformItems(std::uint64_t pixels, SampleRange range) {
  return pixels * itemsFor({0, std::min(range.end - range.first, kPassSamples)});
}

ItemCursor::ItemCursor(const SamplePass& pass, std::uint64_t index) : samples_(pass.samples) {
  if (!pass.list.empty()) {
    listed_ = &pass.list[index];
    return;
  }
  const std::uint32_t itemsPerPixel = itemsFor(pass.samples);
  const std::uint32_t first =
      pass.samples.first + static_cast<std::uint32_t>(index % itemsPerPixel) * gpu::kMaxSamplesPerItem;
  item_ = {static_cast<gpu::uint>(index / itemsPerPixel), 0, first,
           std::min(gpu::kMaxSamplesPerItem, samples_.end - first)};
}

void copyItems(const SamplePass& pass, std::uint64_t first, std::span<gpu::WorkItem> items) {
  ItemCursor cursor(pass, first);
  for (gpu::WorkItem& item : items) item = cursor.next();
}

}  // namespace lavaray
