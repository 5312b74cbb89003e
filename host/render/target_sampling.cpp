#include "render/target_sampling.hpp"

#include <algorithm>

namespace lavaray {

std::uint64_t TargetSampling::planPass() {
  items_ = plan_.nextItems();
  return items_.size();
}

void TargetSampling::take(std::uint64_t index, const gpu::WorkResult& result) {
  plan_.add(items_[index], result);
  taken_ += items_[index].count;
}

double TargetSampling::shareDone() const {
  return std::min(1.0, static_cast<double>(taken_) / plan_.plannedSamples());
}

}  // namespace lavaray
