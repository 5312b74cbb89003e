#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "base/rectangle.hpp"
#include "render/view.hpp"
#include "sampling/pixel_filter.hpp"
#include "sampling/sample_range.hpp"
#include "sampling/sampler.hpp"

namespace lavaray {

struct RenderSettings {
  ImageSize size;  // of the whole picture
  Rectangle crop;  // the part of it to render
  std::uint32_t maxDepth = 8;
  std::uint32_t samples = 1;  // a pixel; 1 is its centre
  // Only these of them; their bounds are multiples of gpu::kMaxSamplesPerItem, or all samples.
  std::optional<SampleRange> range;
  Sampler sampler = Sampler::kSobol;
  PixelFilter filter = PixelFilter::kBox;
  std::uint32_t seed = 0;
  // Instead of `samples`: sample until the picture's RMSE is estimated to be at most this, with at most
  // maxSamples a pixel.
  std::optional<double> targetError;
  std::uint32_t maxSamples = 65536;
  std::optional<double> timeLimitSeconds;
  View view = View::kColor;
  bool asData = false;  // of the views normal and object the numbers behind them, see gpu::kSpecAsData
  bool countRays = false;
  bool recordTimes = false;  // when the device was busy and the host waited
  // Without it there is no picture to look at, to keep in a film or to resume: each row is handed over as
  // soon as it is complete. For one sample a pixel and a view that is no measure.
  bool keepsPicture = true;
  // SPIR-V of render.comp; empty is what the program was built with.
  std::span<const std::uint32_t> shader;
  // Without it the pipeline holds the code for everything that any scene may have; for comparison.
  bool specialized = true;
  // Reads the scene from storage buffers even where texels reach; for comparison.
  bool sceneInStorage = false;
  // Entries of the traversal's stack, at least; those of a prepared pipeline.
  std::uint32_t minStackSize = 0;
  // The rays that an invocation traces together, 1, 2 or 4, where several are possible; empty is what the
  // work is worth.
  std::optional<std::uint32_t> raysPerLane;
};

// Whether each pixel has one sample, in its centre.
inline bool takesCenters(const RenderSettings& settings) {
  return settings.samples == 1 && !settings.targetError;
}

// The samples of each pixel, where there is no target error.
inline SampleRange sampleRange(const RenderSettings& settings) {
  return settings.range.value_or(SampleRange{0, settings.samples});
}

}  // namespace lavaray
