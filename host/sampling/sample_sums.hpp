#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "sampling/pixel_sum.hpp"
#include "sampling/sample_pass.hpp"

namespace lavaray {

// What is kept of a pixel's samples. Films hold the first three, which are written as numbers.
enum class SumKind {
  kCenter = 0,  // glm::vec3: the one sample in the pixel's centre
  kMean = 1,    // PixelSum
  kHalves = 2,  // HalfSums
  kMeasure,     // MeasureSum
  kNone,        // nothing: samples in the pixels' centres are only counted
};

// The sum of samples without an upper bound, which fixed point has no room for. They must be added in one
// order.
struct MeasureSum {
  glm::dvec3 sum{0.0};
  std::uint32_t samples = 0;
};

std::size_t bytesPerPixel(SumKind kind);

// What the samples of an image's pixels add up to so far.
class SampleSums {
 public:
  SampleSums(SumKind kind, std::uint64_t pixels);

  // Adds the results of the pass's items from number `first` on. Centres come in the order of the pixels.
  void add(const SamplePass& pass, std::uint64_t first, std::span<const gpu::WorkResult> results);

  [[nodiscard]] SumKind kind() const { return kind_; }
  [[nodiscard]] std::uint64_t samples() const { return samples_; }  // of all pixels
  [[nodiscard]] std::uint32_t samples(std::uint64_t pixel) const;
  [[nodiscard]] std::uint32_t maxSamples() const;  // of a pixel

  // The means of the pixels from number `first` on; black where there is no sample yet. Not of kMeasure.
  void copyMeans(std::uint64_t first, std::span<glm::vec3> means) const;
  // Of kCenter and kMeasure.
  [[nodiscard]] glm::dvec3 sum(std::uint64_t pixel) const;
  // Of kHalves, of all pixels.
  [[nodiscard]] std::span<HalfSums> halves() { return halves_; }

  // All pixels as a film holds them. Once they are overwritten, `restored` must be told how many of the
  // samples in centres are among them.
  [[nodiscard]] std::span<const std::byte> bytes() const;
  [[nodiscard]] std::span<std::byte> bytes();
  void restored(std::uint64_t centers);

 private:
  void addCenters(std::span<const gpu::WorkResult> results);

  SumKind kind_;
  std::uint64_t pixels_;
  std::uint64_t samples_ = 0;
  // One of them, as the kind says.
  std::vector<float> centers_;  // three a pixel
  std::vector<PixelSum> means_;
  std::vector<HalfSums> halves_;
  std::vector<MeasureSum> measures_;
};

}  // namespace lavaray
