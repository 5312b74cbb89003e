#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "bvh/gpu_scene.hpp"
#include "film/film_file.hpp"
#include "render/settings.hpp"
#include "sampling/adaptive_plan.hpp"
#include "sampling/sample_pass.hpp"
#include "sampling/sample_sums.hpp"

namespace lavaray {

// How far a render's sampling has come.
struct SamplingProgress {
  std::uint64_t pixels;
  std::optional<SampleRange> range;  // of every pixel; none where there is a plan
  std::optional<AdaptivePlan> plan;  // where there is a target error
  SampleSums sums;
  // The pass whose results are taken, and those after it of which items are given to the tracer already.
  std::deque<SamplePass> passes;
  std::uint64_t itemsDone = 0;   // of the first pass
  std::uint64_t itemsGiven = 0;  // of the last pass
};

// For an area of the picture, which with a target error must be the whole crop.
SamplingProgress beginSampling(const GpuScene& scene, const RenderSettings& settings, const Rectangle& area);

// Whether items are left to give to the tracer: those of the last pass from number itemsGiven on, which may
// be a new one. Where there is a plan, a new pass needs the results of all items that were given before;
// until they are added there are none left.
bool hasItems(SamplingProgress& progress);

// Adds the results of the next items. They are of one pass.
void add(SamplingProgress& progress, std::span<const gpu::WorkResult> results);

// In [0, 1]; with a target error it is an estimate.
double shareDone(const SamplingProgress& progress);
double estimatedError(const SamplingProgress& progress);  // RMSE, where there is a target, else 0

// An upper bound, or nearly so, of the number of items of a pass.
std::uint64_t maxItems(const RenderSettings& settings, std::uint64_t pixels);
// The memory that all this takes, in bytes.
std::uint64_t samplingBytes(const RenderSettings& settings, std::uint64_t pixels);

// Lists all of the pass under way, which a film must have.
void listRest(SamplingProgress& progress);
// These fill in what a film's header says about samples, write what follows it, and read both again, after
// which everything is as it was.
void describe(const SamplingProgress& progress, FilmHeader& header);
void write(const SamplingProgress& progress, FilmWriter& film);
void resumeFrom(FilmReader& film, SamplingProgress& progress);

}  // namespace lavaray
