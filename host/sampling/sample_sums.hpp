#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "sampling/pixel_sum.hpp"
#include "sampling/sample_pass.hpp"

namespace lavaray {

// What is kept of a pixel's samples. Films hold only the first three, whose numbers stand in their files.
enum class SumKind {
  kCenter = 0,  // glm::vec3: the one sample in the pixel's centre
  kMean = 1,    // PixelSum
  kHalves = 2,  // HalfSums
  kMeasure,     // MeasureSum
  kNone,        // nothing: samples in the pixels' centres are only counted
};

// The sum of samples that have no upper bound, for which fixed point has no room. It depends on the order in
// which they are added.
struct MeasureSum {
  glm::dvec3 sum{0.0};
  std::uint32_t samples = 0;
};

std::size_t bytesPerPixel(SumKind kind);

// What the samples of each pixel add up to so far.
class SampleSums {
 public:
  SampleSums(SumKind kind, std::uint64_t pixels);

  // Adds the results of the pass's items from number `first` on. Centres come in the order of the pixels.
  void add(const SamplePass& pass, std::uint64_t first, std::span<const gpu::WorkResult> results);

  [[nodiscard]] SumKind kind() const { return kind_; }
  [[nodiscard]] std::uint64_t samples() const { return samples_; }  // of all pixels
  [[nodiscard]] std::uint32_t samples(std::uint64_t pixel) const;
  [[nodiscard]] std::uint32_t maxSamples() const;  // of a pixel

  // The means of the pixels from number `first` on; black where there is no sample yet. Not for kMeasure.
  void copyMeans(std::uint64_t first, std::span<glm::vec3> means) const;
  // For kCenter and kMeasure.
  [[nodiscard]] glm::dvec3 sum(std::uint64_t pixel) const;
  // For kHalves: those of all pixels.
  [[nodiscard]] std::span<HalfSums> halves() { return halves_; }

  // All pixels as a film holds them. Whoever overwrites them calls restored() afterwards, with the number of
  // samples in pixels' centres that they hold.
  [[nodiscard]] std::span<const std::byte> bytes() const;
  [[nodiscard]] std::span<std::byte> bytes();
  void restored(std::uint64_t centers);

 private:
  void addCenters(std::span<const gpu::WorkResult> results);

  SumKind kind_;
  std::uint64_t pixels_;
  std::uint64_t samples_ = 0;
  // The kind says which one of these is used.
  std::vector<float> centers_;  // three per pixel
  std::vector<PixelSum> means_;
  std::vector<HalfSums> halves_;
  std::vector<MeasureSum> measures_;
};

}  // namespace lavaray
