#include "render/tracer.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <string>

#include "base/errors.hpp"
#include "render/scene_buffers.hpp"

namespace lavaray {
namespace {

// Limits the buffers, whatever the picture's size.
constexpr std::uint64_t kMaxBatchItems = std::uint64_t{1} << 20U;
constexpr double kFirstBatchRays = 1U << 15U;
// Short enough for a render to be looked at, kept or stopped ten times a second while two are in flight; long
// enough for the ends of batches, where some of a device's threads have nothing left to do, not to matter.
constexpr double kBatchSeconds = 0.05;
// A pipeline that gives up on more than one in so many invocations is not used again.
constexpr std::uint64_t kRare = 16;

gpu::DispatchConstants dispatchConstants(const GpuScene& scene, const RenderSettings& settings,
                                         const Rectangle& area) {
  const ImagePlane& plane = scene.imagePlane;
  gpu::DispatchConstants constants{};
  constants.pixelSize = plane.size / glm::dvec2(settings.size.width, settings.size.height);
  constants.halfImage = plane.size / 2.0;
  constants.focalLength = static_cast<float>(plane.distance);
  constants.areaX = static_cast<gpu::uint>(area.x0);
  constants.areaY = static_cast<gpu::uint>(area.y0);
  constants.areaWidth = static_cast<gpu::uint>(area.width());
  constants.seed = settings.seed;
  return constants;
}

// Nothing is known yet of how long the scene's rays take; more lights mean more rays per item.
double firstBatchItems(const PipelineVariant& variant) {
  return std::max(double{gpu::kWorkGroupSize}, kFirstBatchRays / (1.0 + variant.lights));
}

// At least two batches, so that the results of one can be taken while the other is traced.
std::uint32_t capacityFor(const vulkan::Device& device, std::uint64_t items) {
  const std::uint64_t reachable =
      std::min<std::uint64_t>(device.limits().storageBufferRange / sizeof(gpu::WorkState),
                              std::uint64_t{device.limits().workGroupsX} * gpu::kWorkGroupSize);
  return static_cast<std::uint32_t>(std::min({kMaxBatchItems, reachable, (items + 1) / 2}));
}

}  // namespace

Tracer::Tracer(vulkan::Device& device, const GpuScene& scene, const RenderSettings& settings,
               const Rectangle& area, std::uint64_t items)
    : device_(device),
      variant_(chooseVariant(device, scene, settings)),
      takesCenters_(lavaray::takesCenters(settings)),
      entryNodes_(entryNodes(scene, settings, area)),
      constants_(dispatchConstants(scene, settings, area)),
      capacity_(capacityFor(device, items)),
      batchItems_(firstBatchItems(variant_)),
      recordsTimes_(settings.recordTimes) {
  if (variant_.skipsEmptyTiles)
    skippedPixels_ = pixelsOfEmptyTiles(entryNodes_, {area.width(), area.height()});
  const std::vector<float> filter = filterTable(settings.filter);
  constants_.maxDepth = variant_.maxDepth;
  constants_.filterSize = static_cast<gpu::uint>(filter.size());
  constants_.tileShift = entryNodes_.shift;
  constants_.tilesAcross = entryNodes_.across;

  sceneBuffers_ = uploadScene(device, scene, variant_.sceneUse);
  sceneBuffers_.push_back(vulkan::Buffer::uploaded(device, "tiles", variant_.sceneUse,
                                                   std::as_bytes(std::span(entryNodes_.groups))));
  const std::vector<float> noTable(4);
  sceneBuffers_.push_back(
      vulkan::Buffer::uploaded(device, "pixel filter", vulkan::BufferUse::kStorage,
                               std::as_bytes(std::span(filter.empty() ? noTable : filter))));
  for (Batch& batch : batches_) {
    batch = makeBatch(device, capacity_, !takesCenters_);
    if (variant_.finishesItems != Expectation::kCertain) makeStates(device, capacity_, batch);
    makeShader(batch, variant_.finishesItems == Expectation::kNo);
  }
}

std::size_t Tracer::deviceBytes() const {
  std::size_t sum = 0;
  for (const vulkan::Buffer& buffer : sceneBuffers_) sum += buffer.size();
  for (const Batch& batch : batches_) sum += bytes(batch);
  return sum;
}

bool Tracer::run(const SamplePass& pass, std::uint64_t first, const TakeResults& takeResults,
                 const Stop& stop) {
  bool isStopped = false;
  for (;;) {
    while (!isStopped && first < pass.items && canBegin()) {
      isStopped = stop();
      if (!isStopped) first += begin(pass, first);
    }
    if (isIdle()) return !isStopped;
    take(takeResults);
  }
}

// The items of the next batch. Towards the end of a pass batches get smaller, so that little is left to be
// done with results when the device has nothing left to trace. Of pixels' centres it ends with a row of
// units, if it holds one, so that no lane takes less than it can.
//
// Based on: Polychronopoulos and Kuck, "Guided Self-Scheduling: A Practical Scheduling Scheme for Parallel
// Supercomputers", 1987.
std::uint32_t Tracer::batchCount(std::uint64_t items, std::uint64_t first) const {
  const std::uint64_t left = items - first;
  const auto usual = static_cast<std::uint64_t>(batchItems_);
  const std::uint64_t wanted = std::min(usual, std::max(left / 2, usual / 8));
  const std::uint64_t end = first + std::min({wanted, left, std::uint64_t{capacity_}});
  if (!takesCenters_ || end == items) return static_cast<std::uint32_t>(end - first);
  const std::uint64_t rowOfUnits = std::uint64_t{constants_.areaWidth} * variant_.raysPerLane;
  const std::uint64_t wholeRows = end / rowOfUnits * rowOfUnits;
  return static_cast<std::uint32_t>((wholeRows > first ? wholeRows : end) - first);
}

std::uint32_t Tracer::begin(const SamplePass& pass, std::uint64_t first) {
  assert(canBegin());
  Batch& batch = batchAt(begun_++);
  batch.begin = Batch::Clock::now();
  batch.first = first;
  batch.count = batchCount(pass.items, first);
  if (takesCenters_) {
    batch.traced = batch.count;
    batch.samples = batch.count;
  } else {
    listItems(pass, batch);
  }
  if (batch.traced > 0) start(batch, batch.direct ? *batch.direct : *batch.resumable, gpu::kModeAll);
  return batch.count;
}

void Tracer::take(const TakeResults& takeResults) {
  assert(!isIdle());
  Batch& batch = batchAt(taken_);
  if (batch.traced > 0) finish(batch);
  ++taken_;
  counts_.samples += batch.samples;
  counts_.skippedSamples += batch.skippedSamples;
  takeResultsOf(batch, takeResults);
  adaptBatch(batch);
}

// Sets the size of the next batch by the time of one that is done. Others of another size may be under way.
void Tracer::adaptBatch(const Batch& batch) {
  const Batch::Clock::time_point now = Batch::Clock::now();
  const double seconds = std::chrono::duration<double>(now - std::max(batch.begin, lastTaken_)).count();
  lastTaken_ = now;
  // The time of the first batch says nothing, since drivers compile the shader in it; nor does that of one
  // that the end of a pass made short.
  const bool isShort = 2.0 * batch.count < batchItems_ && seconds < kBatchSeconds;
  if (isWarm_ && isShort) return;
  const double items = isWarm_ ? batch.count * kBatchSeconds / seconds : 4.0 * batchItems_;
  const double wanted = std::clamp(items, 0.25 * batchItems_, 4.0 * batchItems_);
  batchItems_ = std::clamp(wanted, double{gpu::kWorkGroupSize}, static_cast<double>(kMaxBatchItems));
  isWarm_ = true;
}

// Lists the batch's items for the device, without those that show nothing.
void Tracer::listItems(const SamplePass& pass, Batch& batch) const {
  batch.samples = 0;
  batch.skippedSamples = 0;
  batch.traced = 0;
  batch.tracedItems.clear();
  const std::span<gpu::WorkItem> list = items(batch);
  copyItems(pass, batch.first, list);
  for (std::uint32_t i = 0; i < batch.count; ++i) {
    if (skips(list[i].pixel)) {
      batch.skippedSamples += list[i].count;
      continue;
    }
    batch.samples += list[i].count;
    if (variant_.skipsEmptyTiles) batch.tracedItems.push_back(i);
    list[batch.traced++] = list[i];
  }
}

void Tracer::takeResultsOf(Batch& batch, const TakeResults& takeResults) const {
  const gpu::WorkResult* next = results(batch);
  if (variant_.skipsEmptyTiles) {
    batch.allResults.assign(batch.count, {});
    for (const std::uint32_t item : batch.tracedItems) batch.allResults[item] = *next++;
    next = batch.allResults.data();
  }
  takeResults(batch.first, {next, batch.count});
}

void Tracer::makeShader(Batch& batch, bool resumable) {
  variant_.specialization[gpu::kSpecResumable] = resumable ? 1 : 0;
  std::optional<vulkan::ComputeShader>& shader = resumable ? batch.resumable : batch.direct;
  shader.emplace(device_, resumable ? variant_.resumable : variant_.shader, variant_.specialization,
                 sceneBuffers_, sizeof constants_, batch.buffers);
  if (recordsTimes_) shader->recordTimes();
}

// How many invocations a batch takes.
std::uint32_t Tracer::lanes(const Batch& batch, std::uint32_t raysPerLane) const {
  const std::uint32_t itemsPerLane = std::max(raysPerLane / gpu::kMinSamplesPerItem, 1U);
  if (!takesCenters_) return (batch.traced + itemsPerLane - 1) / itemsPerLane;
  const auto first = static_cast<std::uint32_t>(batch.first);
  const std::uint32_t firstRow = first / constants_.areaWidth / raysPerLane;
  const std::uint32_t lastRow = (first + batch.count - 1) / constants_.areaWidth / raysPerLane;
  const std::uint32_t across = (constants_.areaWidth + gpu::kUnitWidth - 1) / gpu::kUnitWidth;
  return (lastRow - firstRow + 1) * across * gpu::kLanesPerUnit;
}

void Tracer::start(Batch& batch, vulkan::ComputeShader& shader, gpu::uint mode) {
  status(batch) = {};
  constants_.firstPixel = static_cast<gpu::uint>(batch.first);
  constants_.itemCount = batch.traced;
  constants_.mode = mode;
  const bool isResumable = batch.resumable && &shader == &*batch.resumable;
  const std::uint32_t lanesOfBatch = lanes(batch, isResumable ? 1 : variant_.raysPerLane);
  shader.start((lanesOfBatch + gpu::kWorkGroupSize - 1) / gpu::kWorkGroupSize,
               std::as_bytes(std::span(&constants_, 1)));
}

gpu::DispatchStatus Tracer::wait(Batch& batch, vulkan::ComputeShader& shader) {
  shader.wait();
  if (recordsTimes_) activity_.add(shader.times());
  const gpu::DispatchStatus found = status(batch);
  ++counts_.dispatches;
  counts_.shadowRays += found.shadowRays;
  counts_.mirrorRays += found.mirrorRays;
  counts_.skippedShadowRays += found.skippedShadowRays;
  for (gpu::uint i = 0; i < gpu::kTurnKinds; ++i)
    counts_.turns[i] += (std::uint64_t{found.higherOfTurns[i]} << 32U) | found.turns[i];
  return found;
}

// Waits for the batch and has the device resume what it left half done.
void Tracer::finish(Batch& batch) {
  std::uint32_t unfinishedBefore = batch.traced + 1;
  if (batch.direct) {
    const std::uint32_t unfinished = wait(batch, *batch.direct).unfinished;
    if (unfinished == 0) return;
    counts_.givenUp += unfinished;
    const bool wastesTime = kRare * std::uint64_t{unfinished} > lanes(batch, variant_.raysPerLane);
    if (wastesTime || !batch.canResume) batch.direct.reset();
    if (!batch.canResume) makeStates(device_, capacity_, batch);
    if (!batch.resumable) makeShader(batch, true);
    start(batch, *batch.resumable, gpu::kModeUnfinished);
  }
  for (;;) {
    const gpu::DispatchStatus found = wait(batch, *batch.resumable);
    if (found.unfinished == 0) return;
    if (found.stuck == found.unfinished && found.unfinished == unfinishedBefore) {
      throw Error(ExitCode::kDevice,
                  device_.description().name + " gives up " + std::to_string(found.stuck) +
                      " rays that pass too many surfaces or meet too many lights; a scene "
                      "where fewer overlap can be rendered, or another --device may do more");
    }
    unfinishedBefore = found.unfinished;
    start(batch, *batch.resumable, gpu::kModeResumed);
  }
}

}  // namespace lavaray
