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

// How a device traces much the fastest. It changes no bit of a picture.
struct Tuning {
  bool sceneInStorage = false;    // a scene that is searched is read from storage buffers, not as texels
  std::uint32_t raysPerLane = 1;  // that an invocation traces together: 1, 2 or 4
  bool operator==(const Tuning&) const = default;
};

struct RenderSettings : v0::SamplingOptions {
  ImageSize size;       // of the whole picture
  Rectangle crop;       // the part of it to render
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
  // The rays that an invocation traces together, 1, 2 or 4, where several are possible; for comparison. Empty
  // is what the work is worth.
  std::optional<std::uint32_t> raysPerLane;
  std::optional<Tuning> tuning;  // empty is the usual one (tuning.hpp)
};

// Whether each pixel has one sample, in its centre.
inline bool takesCenters(const v0::SamplingOptions& settings) {
  return settings.samples == 1 && !settings.targetError;
}

// The samples of each pixel, where there is no target error.
inline SampleRange sampleRange(const RenderSettings& settings) {
  return settings.range.value_or(SampleRange{0, settings.samples});
}

}  // namespace lavaray
