#pragma once

#include <algorithm>
#include <cassert>
#include <span>
#include <vector>

#include "base/huge_pages.hpp"
#include "render/sampling.hpp"
#include "render/view.hpp"

namespace lavaray {

// One sample in each pixel's centre.
class CenterSampling : public Sampling {
 public:
  // Without `keepsValues` they are only counted, and there are no values to copy and no film.
  CenterSampling(std::uint64_t pixels, View view, bool keepsValues) : Sampling(pixels), view_(view) {
    if (!keepsValues) return;
    values_.reserve(3 * pixels);
    preferHugePages(values_.data(), values_.capacity() * sizeof(float));
    values_.resize(3 * pixels);
  }

  void makeItems(std::uint64_t first, std::span<gpu::WorkItem> items) const override {
    for (gpu::WorkItem& item : items) item = {static_cast<gpu::uint>(first++), 0, 0, 1};
  }
  void copyValues(std::uint64_t first, std::span<glm::vec3> values) const override {
    assert(3 * (first + values.size()) <= values_.size());
    std::copy_n(&values_[3 * first], 3 * values.size(), &values.front().x);
  }
  [[nodiscard]] std::uint32_t samples(std::uint64_t pixel) const override { return pixel < done_ ? 1 : 0; }
  [[nodiscard]] std::uint32_t mostSamples() const override { return 1; }
  [[nodiscard]] double shareDone() const override {
    return static_cast<double>(done_) / static_cast<double>(pixels());
  }

  void describe(FilmHeader& header) const override {
    header.kind = FilmKind::kCenters;
    header.itemsDone = done_;
  }
  void write(FilmWriter& film) const override { film.write(std::as_bytes(std::span(values_))); }
  void read(FilmReader& film) override {
    film.readPixels(std::as_writable_bytes(std::span(values_)));
    done_ = film.header().itemsDone;
    goOnAt(done_, pixels());
  }

 private:
  std::uint64_t planPass() override { return pixels() - done_; }
  void take(std::uint64_t first, std::span<const gpu::WorkResult> results) override {
    done_ += results.size();
    if (values_.empty()) return;
    float* value = &values_[3 * first];
    for (const gpu::WorkResult& result : results) {
      const glm::vec3 color =
          isMeasure(view_) ? glm::vec3(static_cast<float>(measure(view_, result.sum, 1))) : result.sum;
      value = std::copy_n(&color.x, 3, value);
    }
  }

  View view_;
  std::vector<float> values_;  // three a pixel, or none at all
  std::uint64_t done_ = 0;
};

}  // namespace lavaray
