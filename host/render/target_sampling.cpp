#include "render/target_sampling.hpp"

#include <algorithm>
#include <span>

namespace lavaray {

std::uint64_t TargetSampling::planPass() {
  items_ = plan_.nextItems();
  return items_.size();
}

void TargetSampling::take(std::uint64_t first, std::span<const gpu::WorkResult> results) {
  for (const gpu::WorkResult& result : results) {
    const gpu::WorkItem& item = items_[first++];
    plan_.add(item, result);
    taken_ += item.count;
  }
}

void TargetSampling::copyValues(std::uint64_t first, std::span<glm::vec3> values) const {
  for (glm::vec3& value : values) value = plan_.mean(first++);
}

std::uint32_t TargetSampling::mostSamples() const {
  std::uint32_t most = 0;
  for (std::size_t pixel = 0; pixel < plan_.pixels().size(); ++pixel)
    most = std::max(most, plan_.samples(pixel));
  return most;
}

double TargetSampling::shareDone() const {
  return std::min(1.0, static_cast<double>(taken_) / plan_.plannedSamples());
}

void TargetSampling::describe(FilmHeader& header) const {
  header.kind = FilmKind::kTarget;
  header.itemsPending = passItems() - itemsDone();
}

void TargetSampling::write(FilmWriter& film) const {
  film.write(std::as_bytes(plan_.pixels()));
  film.write(std::as_bytes(std::span(items_).subspan(itemsDone())));
}

// The plan of a pass cannot be made again from sums that have some of its results, so what is left of it is
// kept.
void TargetSampling::read(FilmReader& film) {
  std::vector<HalfSums> pixels(plan_.pixels().size());
  film.readPixels(std::as_writable_bytes(std::span(pixels)));
  plan_.goOnWith(std::move(pixels));
  items_.resize(film.header().itemsPending);
  film.readItems(std::as_writable_bytes(std::span(items_)));
  goOnAt(0, items_.size());
  taken_ = 0;
  for (const HalfSums& pixel : plan_.pixels())
    taken_ += pixel.halves[0].samples() + pixel.halves[1].samples();
}

}  // namespace lavaray
