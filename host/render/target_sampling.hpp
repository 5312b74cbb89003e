#pragma once

#include <algorithm>
#include <vector>

#include "render/sampling.hpp"
#include "sampling/adaptive.hpp"

namespace lavaray {

// Samples by the plan of AdaptiveSampling until the image's estimated error is the target.
class TargetSampling : public Sampling {
 public:
  explicit TargetSampling(AdaptiveSampling plan) : Sampling(plan.pixels().size()), plan_(std::move(plan)) {}

  void makeItems(std::uint64_t first, std::span<gpu::WorkItem> items) const override {
    std::copy_n(items_.begin() + static_cast<std::ptrdiff_t>(first), items.size(), items.begin());
  }
  void copyValues(std::uint64_t first, std::span<glm::vec3> values) const override;
  [[nodiscard]] std::uint32_t samples(std::uint64_t pixel) const override { return plan_.samples(pixel); }
  [[nodiscard]] std::uint32_t mostSamples() const override;
  [[nodiscard]] double estimatedError(std::uint64_t pixel) const override {
    return plan_.estimatedError(pixel);
  }
  [[nodiscard]] double estimatedError() const override { return plan_.estimatedError(); }
  [[nodiscard]] double shareDone() const override;
  [[nodiscard]] bool reachedGoal() const override { return plan_.reachedTarget(); }

  void describe(FilmHeader& header) const override;
  void write(FilmWriter& film) const override;
  void read(FilmReader& film) override;

 private:
  std::uint64_t planPass() override;
  void take(std::uint64_t first, std::span<const gpu::WorkResult> results) override;

  AdaptiveSampling plan_;
  std::vector<gpu::WorkItem> items_;
  std::uint64_t taken_ = 0;  // samples
};

}  // namespace lavaray
