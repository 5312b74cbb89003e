#pragma once

#include <span>
#include <vector>

#include "render/sampling.hpp"
#include "render/view.hpp"

namespace lavaray {

// One sample in each pixel's centre.
class CenterSampling : public Sampling {
 public:
  CenterSampling(std::uint64_t pixels, View view) : view_(view), values_(pixels) {}

  [[nodiscard]] gpu::WorkItem item(std::uint64_t index) const override {
    return {static_cast<gpu::uint>(index), 0, 0, 1};
  }
  [[nodiscard]] glm::vec3 value(std::uint64_t pixel) const override { return values_[pixel]; }
  [[nodiscard]] std::uint32_t samples(std::uint64_t pixel) const override { return pixel < done_ ? 1 : 0; }
  [[nodiscard]] double shareDone() const override {
    return static_cast<double>(done_) / static_cast<double>(values_.size());
  }

  void describe(FilmHeader& header) const override {
    header.kind = FilmKind::kCenters;
    header.itemsDone = done_;
  }
  void write(FilmWriter& film) const override { film.write(std::as_bytes(std::span(values_))); }
  void read(FilmReader& film) override {
    film.readPixels(std::as_writable_bytes(std::span(values_)));
    done_ = film.header().itemsDone;
    goOnAt(done_, values_.size());
  }

 private:
  std::uint64_t planPass() override { return values_.size() - done_; }
  void take(std::uint64_t index, const gpu::WorkResult& result) override {
    values_[index] =
        isMeasure(view_) ? glm::vec3(static_cast<float>(measure(view_, result.sum))) : result.sum;
    ++done_;
  }

  View view_;
  std::vector<glm::vec3> values_;
  std::uint64_t done_ = 0;
};

}  // namespace lavaray
