#pragma once

#include <vector>

#include "render/sampling.hpp"
#include "render/settings.hpp"

namespace lavaray {

// The same samples for every pixel, in rounds of a few a pixel: a render that is stopped has about the same
// number everywhere.
class FixedSampling : public Sampling {
 public:
  FixedSampling(std::uint64_t pixels, SampleRange range, View view);

  // Of a round; the most that passItems() becomes.
  static std::uint64_t mostItems(std::uint64_t pixels, SampleRange range);

  static std::size_t bytesPerPixel(View view) {
    return sizeof(PixelSum) + (isMeasure(view) ? sizeof(glm::dvec3) : 0);
  }

  void makeItems(std::uint64_t first, std::span<gpu::WorkItem> items) const override;
  void copyValues(std::uint64_t first, std::span<glm::vec3> values) const override;
  [[nodiscard]] std::uint32_t samples(std::uint64_t pixel) const override { return sums_[pixel].samples(); }
  [[nodiscard]] std::uint32_t mostSamples() const override;
  [[nodiscard]] double shareDone() const override;

  void describe(FilmHeader& header) const override;
  void write(FilmWriter& film) const override;
  void read(FilmReader& film) override;

 private:
  void startRound(std::uint32_t first, std::uint32_t size);
  std::uint64_t planPass() override;
  [[nodiscard]] float measuredValue(std::uint64_t pixel) const;
  [[nodiscard]] gpu::WorkItem item(std::uint64_t index) const;
  void take(std::uint64_t first, std::span<const gpu::WorkResult> results) override;

  SampleRange range_;
  View view_;
  std::uint32_t roundFirst_;      // sample of this round
  std::uint32_t roundSize_ = 0;   // samples a pixel
  std::uint32_t roundItems_ = 1;  // a pixel
  std::vector<PixelSum> sums_;
  // Of views that are measures. Results come in the order of their items, so these sums need no fixed point,
  // which has bounds.
  std::vector<glm::dvec3> measured_;
};

}  // namespace lavaray
