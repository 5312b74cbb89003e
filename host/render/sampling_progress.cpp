#include "render/sampling_progress.hpp"

#include <algorithm>
#include <utility>

#include "render/small_objects.hpp"

namespace lavaray {
namespace {

SumKind sumKind(const RenderSettings& settings) {
  if (settings.targetError) return SumKind::kHalves;
  if (takesCenters(settings)) return settings.keepsPicture ? SumKind::kCenter : SumKind::kNone;
  return isMeasure(settings.view) ? SumKind::kMeasure : SumKind::kMean;
}

AdaptiveGoal adaptiveGoal(const RenderSettings& settings) {
  return {*settings.targetError, settings.maxSamples, settings.sampler == Sampler::kSobol};
}

SamplePass passAfterLast(const SamplingProgress& progress) {
  return nextUniformPass(progress.pixels, *progress.range, progress.passes.back().samples);
}

void append(SamplingProgress& progress, SamplePass pass) {
  progress.passes.push_back(std::move(pass));
  progress.itemsGiven = 0;
}

// Leaves the last one, which says where to go on.
void dropDonePasses(SamplingProgress& progress) {
  while (progress.passes.size() > 1 && progress.itemsDone == progress.passes.front().items) {
    progress.passes.pop_front();
    progress.itemsDone = 0;
  }
}

}  // namespace

SamplingProgress beginSampling(const GpuScene& scene, const RenderSettings& settings, const Rectangle& area) {
  SamplingProgress progress{area.pixels(), {}, {}, SampleSums(sumKind(settings), area.pixels()), {}, 0, 0};
  if (settings.targetError) {
    progress.plan.emplace(ImageSize{area.width(), area.height()}, adaptiveGoal(settings),
                          pixelsOfSmallObjects(scene, settings));
    progress.passes.emplace_back();
  } else {
    progress.range = sampleRange(settings);
    progress.passes.push_back({0, {progress.range->first, progress.range->first}, {}});
  }
  return progress;
}

bool hasItems(SamplingProgress& progress) {
  if (progress.itemsGiven > 0) listRest(progress);
  if (progress.itemsGiven < progress.passes.back().items) return true;
  if (!progress.plan) {
    SamplePass next = passAfterLast(progress);
    if (next.items > 0) append(progress, std::move(next));
  } else if (progress.itemsDone == progress.passes.front().items) {
    append(progress,
           progress.plan->beginPass(progress.sums.halves(), std::move(progress.passes.front().list)));
  }
  dropDonePasses(progress);
  return progress.itemsGiven < progress.passes.back().items;
}

void listRest(SamplingProgress& progress) {
  if (progress.plan) progress.plan->listRest(progress.passes.back(), progress.sums.halves());
}

void add(SamplingProgress& progress, std::span<const gpu::WorkResult> results) {
  progress.sums.add(progress.passes.front(), progress.itemsDone, results);
  progress.itemsDone += results.size();
  if (progress.plan) progress.plan->advance(progress.itemsDone, progress.sums.halves());
  const bool isLastDone = progress.passes.size() == 1 && progress.itemsDone == progress.passes.front().items;
  if (isLastDone && !progress.plan) append(progress, passAfterLast(progress));
  dropDonePasses(progress);
}

double shareDone(const SamplingProgress& progress) {
  const double planned =
      progress.plan ? progress.plan->plannedSamples()
                    : static_cast<double>(progress.pixels) * (progress.range->end - progress.range->first);
  return std::min(1.0, static_cast<double>(progress.sums.samples()) / planned);
}

double estimatedError(const SamplingProgress& progress) {
  return progress.plan ? progress.plan->estimatedError() : 0.0;
}

std::uint64_t maxItems(const RenderSettings& settings, std::uint64_t pixels) {
  return settings.targetError ? 2 * pixels : maxUniformItems(pixels, sampleRange(settings));
}

std::uint64_t samplingBytes(const RenderSettings& settings, std::uint64_t pixels) {
  const std::size_t ofPlan = settings.targetError ? AdaptivePlan::bytesPerPixel() : 0;
  return pixels * (bytesPerPixel(sumKind(settings)) + ofPlan);
}

void describe(const SamplingProgress& progress, FilmHeader& header) {
  const SamplePass& pass = progress.passes.front();
  header.kind = progress.sums.kind();
  switch (header.kind) {
    case SumKind::kCenter:
      header.itemsDone = progress.sums.samples();
      break;
    case SumKind::kHalves:
      header.itemsPending = pass.items - progress.itemsDone;
      header.discoveries = progress.plan->discoveries();
      break;
    default:
      header.roundFirst = pass.samples.first;
      header.roundSize = pass.samples.end - pass.samples.first;
      header.itemsDone = progress.itemsDone;
  }
}

void write(const SamplingProgress& progress, FilmWriter& film) {
  film.write(progress.sums.bytes());
  film.write(
      std::as_bytes(std::span(progress.passes.front().list).subspan(progress.plan ? progress.itemsDone : 0)));
}

void resumeFrom(FilmReader& film, SamplingProgress& progress) {
  const FilmHeader& header = film.header();
  film.readPixels(progress.sums.bytes());
  progress.sums.restored(header.itemsDone);
  progress.passes.clear();
  progress.itemsDone = header.itemsDone;
  if (progress.plan) {
    // A pass cannot be planned again from sums that already have some of its results, so what is left of it
    // is in the film.
    progress.plan->resumeFrom(progress.sums.halves(), header.discoveries);
    WorkList pending(header.itemsPending);
    film.readItems(std::as_writable_bytes(std::span(pending)));
    progress.passes.push_back(listedPass(std::move(pending)));
    progress.itemsDone = 0;
  } else if (progress.sums.kind() == SumKind::kCenter) {
    progress.passes.push_back(uniformPass(progress.pixels, {0, 1}));
  } else {
    progress.passes.push_back(
        uniformPass(progress.pixels, {header.roundFirst, header.roundFirst + header.roundSize}));
  }
  progress.itemsGiven = progress.itemsDone;
}

}  // namespace lavaray
