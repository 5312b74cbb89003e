#pragma once

#include <cstdint>
#include <optional>

#include "bvh/gpu_scene.hpp"
#include "film/film_file.hpp"
#include "render/settings.hpp"
#include "sampling/adaptive_plan.hpp"
#include "sampling/sample_pass.hpp"
#include "sampling/sample_sums.hpp"

namespace lavaray {

// How far the samples of a render have come.
struct SamplingProgress {
  std::uint64_t pixels;
  std::optional<SampleRange> range;  // of every pixel; none where there is a plan
  std::optional<AdaptivePlan> plan;  // where there is a target error
  SampleSums sums;
  SamplePass pass;
  std::uint64_t itemsDone = 0;  // of the pass
};

// For an area of the picture. With a target error that is the whole crop.
SamplingProgress beginSampling(const GpuScene& scene, const RenderSettings& settings, const Rectangle& area);

// Chooses the next pass once the one before is done. False where nothing is left to do.
bool beginPass(SamplingProgress& progress);

// Adds the results of the pass's next items.
void add(SamplingProgress& progress, std::span<const gpu::WorkResult> results);

// In [0, 1]; with a target error as far as can be told now.
double shareDone(const SamplingProgress& progress);
double estimatedError(const SamplingProgress& progress);  // RMSE, where there is a target, else 0

// An upper bound, or nearly so, of the items of a pass.
std::uint64_t maxItems(const RenderSettings& settings, std::uint64_t pixels);
// The bytes that all this takes in memory.
std::uint64_t samplingBytes(const RenderSettings& settings, std::uint64_t pixels);

// Fills in what a film's header says of samples, writes what comes behind it, and reads both again, after
// which everything is as it was.
void describe(const SamplingProgress& progress, FilmHeader& header);
void write(const SamplingProgress& progress, FilmWriter& film);
void resumeFrom(FilmReader& film, SamplingProgress& progress);

}  // namespace lavaray
