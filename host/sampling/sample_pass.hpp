#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/uninitialized_vector.hpp"
#include "interface.h"
#include "sampling/sample_range.hpp"

namespace lavaray {

using WorkList = UninitializedVector<gpu::WorkItem>;

// The samples that are taken before the next ones are chosen, divided into work items. A pass takes either
// the same samples of every pixel or those of a list.
struct SamplePass {
  std::uint64_t items = 0;    // 0: nothing is left to do
  SampleRange samples{0, 0};  // of every pixel
  WorkList list;              // empty where all pixels have the same samples
};

SamplePass uniformPass(std::uint64_t pixels, SampleRange samples);
SamplePass listedPass(WorkList list);

// The pass after one of the samples `before`, in a render that takes the samples `range` of every pixel.
// Passes are short, so that a render that is stopped has about the same number of samples everywhere.
SamplePass nextUniformPass(std::uint64_t pixels, SampleRange range, SampleRange before);
// An upper bound of the number of items of these passes.
std::uint64_t maxUniformItems(std::uint64_t pixels, SampleRange range);

// Goes through the items of a pass from number `index` on, which it has, without a division for each.
class ItemCursor {
 public:
  ItemCursor(const SamplePass& pass, std::uint64_t index);

  gpu::WorkItem next() {
    if (listed_ != nullptr) return *listed_++;
    const gpu::WorkItem item = item_;
    item_.first += item_.count;
    if (item_.first == samples_.end) {
      ++item_.pixel;
      item_.first = samples_.first;
    }
    item_.count = std::min(gpu::kMaxSamplesPerItem, samples_.end - item_.first);
    return item;
  }

 private:
  const gpu::WorkItem* listed_ = nullptr;
  SampleRange samples_;
  gpu::WorkItem item_{};
};

// The items from number `first` on.
void copyItems(const SamplePass& pass, std::uint64_t first, std::span<gpu::WorkItem> items);

}  // namespace lavaray
