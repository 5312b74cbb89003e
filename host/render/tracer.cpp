#include "render/tracer.hpp"

#include <algorithm>
#include <chrono>
#include <string>

#include "base/errors.hpp"
#include "render/scene_buffers.hpp"

namespace lavaray {
namespace {

// Limits the buffers, whatever the picture's size.
constexpr std::uint64_t kMaxBatchItems = std::uint64_t{1} << 20U;
constexpr double kFirstBatchRays = 1U << 15U;
constexpr double kBatchSeconds = 0.1;

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

// The pixels that a unit of lanes takes, as in lane.glsl.
struct PixelBlock {
  std::uint32_t width;
  std::uint32_t height;
};
PixelBlock unitBlock(std::uint32_t raysPerLane) {
  if (raysPerLane == 1) return {8, 1};
  return raysPerLane == 2 ? PixelBlock{4, 4} : PixelBlock{8, 4};
}

std::uint32_t capacityFor(const vulkan::Device& device, std::uint64_t items) {
  const std::uint64_t reachable =
      std::min<std::uint64_t>(device.limits().storageBufferRange / sizeof(gpu::WorkState),
                              std::uint64_t{device.limits().workGroupsX} * gpu::kWorkGroupSize);
  return static_cast<std::uint32_t>(std::min({kMaxBatchItems, reachable, items}));
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
      batchItems_(firstBatchItems(variant_)) {
  if (variant_.skipsEmptyTiles)
    skippedPixels_ = pixelsOfEmptyTiles(entryNodes_, {area.width(), area.height()});
  const std::vector<float> filter = filterTable(settings.filter);
  constants_.maxDepth = variant_.maxDepth;
  constants_.filterSize = static_cast<gpu::uint>(filter.size());
  constants_.tileShift = entryNodes_.shift;
  constants_.tilesAcross = entryNodes_.across;

  buffers_ = uploadScene(device, scene, variant_.sceneUse);
  buffers_.push_back(vulkan::Buffer::uploaded(device, "tiles", variant_.sceneUse,
                                              std::as_bytes(std::span(entryNodes_.groups))));
  const std::vector<float> noTable(4);
  buffers_.push_back(vulkan::Buffer::uploaded(device, "pixel filter", vulkan::BufferUse::kStorage,
                                              std::as_bytes(std::span(filter.empty() ? noTable : filter))));
  const std::size_t workItems = takesCenters_ ? 1 : capacity_;
  buffers_.push_back(vulkan::Buffer::shared(device, "work items", workItems * sizeof(gpu::WorkItem)));
  buffers_.push_back(vulkan::Buffer::shared(device, "results", capacity_ * sizeof(gpu::WorkResult)));
  buffers_.push_back(vulkan::Buffer::shared(device, "unfinished work", sizeof(gpu::WorkState)));
  buffers_.push_back(vulkan::Buffer::shared(device, "dispatch status", sizeof(gpu::DispatchStatus)));
  if (variant_.finishesItems) direct_.emplace(makeShader(false));
}

std::size_t Tracer::deviceBytes() const {
  std::size_t bytes = 0;
  for (const vulkan::Buffer& buffer : buffers_) bytes += buffer.size();
  return bytes;
}

bool Tracer::run(const SamplePass& pass, std::uint64_t first, const TakeResults& takeResults,
                 const Stop& stop) {
  using Clock = std::chrono::steady_clock;
  while (first < pass.items) {
    if (stop()) return false;
    const std::uint32_t count = batchCount(pass.items, first);
    const Clock::time_point start = Clock::now();
    const std::uint32_t traced = makeBatch(pass, first, count);
    if (traced > 0) dispatchUntilFinished(traced);
    takeBatch(first, count, takeResults);
    adaptBatch(std::chrono::duration<double>(Clock::now() - start).count());
    first += count;
  }
  return true;
}

// The items of the next batch. Of pixels' centres it ends with a row of units, if it holds one, so that no
// lane takes less than it can.
std::uint32_t Tracer::batchCount(std::uint64_t items, std::uint64_t first) const {
  const std::uint64_t wanted = std::min(static_cast<std::uint64_t>(batchItems_), std::uint64_t{capacity_});
  const std::uint64_t end = std::min(first + wanted, items);
  if (!takesCenters_ || end == items) return static_cast<std::uint32_t>(end - first);
  const std::uint64_t rowOfUnits =
      std::uint64_t{constants_.areaWidth} * unitBlock(variant_.raysPerLane).height;
  const std::uint64_t wholeRows = end / rowOfUnits * rowOfUnits;
  return static_cast<std::uint32_t>((wholeRows > first ? wholeRows : end) - first);
}

void Tracer::adaptBatch(double seconds) {
  // The time of the first batch says nothing, since drivers compile the shader in it.
  const double factor = isWarm_ ? std::clamp(kBatchSeconds / seconds, 0.25, 4.0) : 4.0;
  batchItems_ =
      std::clamp(batchItems_ * factor, double{gpu::kWorkGroupSize}, static_cast<double>(kMaxBatchItems));
  isWarm_ = true;
}

// Returns the number of items to trace.
std::uint32_t Tracer::makeBatch(const SamplePass& pass, std::uint64_t first, std::uint32_t count) {
  constants_.firstPixel = static_cast<gpu::uint>(first);
  if (takesCenters_) {
    counts_.samples += count;
    return count;
  }
  const std::span items(reinterpret_cast<gpu::WorkItem*>(buffers_[gpu::kBindingWork].bytes()), count);
  copyItems(pass, first, items);
  traced_.clear();
  std::uint32_t traced = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (skips(items[i].pixel)) {
      counts_.skippedSamples += items[i].count;
      continue;
    }
    counts_.samples += items[i].count;
    if (variant_.skipsEmptyTiles) traced_.push_back(i);
    items[traced++] = items[i];
  }
  return traced;
}

void Tracer::takeBatch(std::uint64_t first, std::uint32_t count, const TakeResults& takeResults) {
  const auto* results = reinterpret_cast<const gpu::WorkResult*>(buffers_[gpu::kBindingResults].bytes());
  if (variant_.skipsEmptyTiles) {
    allResults_.assign(count, {});
    for (const std::uint32_t item : traced_) allResults_[item] = *results++;
    results = allResults_.data();
  }
  takeResults(first, {results, count});
}

vulkan::ComputeShader Tracer::makeShader(bool resumable) {
  if (resumable) {
    direct_.reset();  // it is bound to the buffer that is replaced here, and the scene turned out to need the
                      // other one
    buffers_[gpu::kBindingStates] =
        vulkan::Buffer::shared(device_, "unfinished work", capacity_ * sizeof(gpu::WorkState));
  }
  if (resumable) variant_.raysPerLane = 1;
  variant_.specialization[gpu::kSpecResumable] = resumable ? 1 : 0;
  return {device_, resumable ? variant_.resumable : variant_.shader, variant_.specialization, buffers_,
          sizeof constants_};
}

// How many invocations a batch takes.
std::uint32_t Tracer::lanes(std::uint32_t count) const {
  if (!takesCenters_) return count;
  const PixelBlock block = unitBlock(variant_.raysPerLane);
  const std::uint32_t firstRow = constants_.firstPixel / constants_.areaWidth / block.height;
  const std::uint32_t lastRow = (constants_.firstPixel + count - 1) / constants_.areaWidth / block.height;
  const std::uint32_t across = (constants_.areaWidth + block.width - 1) / block.width;
  return (lastRow - firstRow + 1) * across * gpu::kLanesPerUnit;
}

gpu::DispatchStatus Tracer::dispatch(vulkan::ComputeShader& shader, std::uint32_t count, gpu::uint mode) {
  auto* status = reinterpret_cast<gpu::DispatchStatus*>(buffers_[gpu::kBindingStatus].bytes());
  *status = {};
  constants_.itemCount = count;
  constants_.mode = mode;
  shader.dispatch((lanes(count) + gpu::kWorkGroupSize - 1) / gpu::kWorkGroupSize,
                  std::as_bytes(std::span(&constants_, 1)));
  ++counts_.dispatches;
  counts_.shadowRays += status->shadowRays;
  counts_.mirrorRays += status->mirrorRays;
  counts_.skippedShadowRays += status->skippedShadowRays;
  return *status;
}

void Tracer::dispatchUntilFinished(std::uint32_t count) {
  gpu::uint mode = gpu::kModeAll;
  if (direct_) {
    if (dispatch(*direct_, count, mode).unfinished == 0) return;
    mode = gpu::kModeUnfinished;
  }
  if (!resumable_) resumable_.emplace(makeShader(true));
  std::uint32_t unfinishedBefore = count + 1;
  for (;;) {
    const gpu::DispatchStatus status = dispatch(*resumable_, count, mode);
    if (status.unfinished == 0) return;
    if (status.stuck == status.unfinished && status.unfinished == unfinishedBefore) {
      throw Error(ExitCode::kDevice,
                  device_.description().name + " gives up " + std::to_string(status.stuck) +
                      " rays that pass too many surfaces or meet too many lights; a scene "
                      "where fewer overlap can be rendered, or another --device may do more");
    }
    unfinishedBefore = status.unfinished;
    mode = gpu::kModeResumed;
  }
}

}  // namespace lavaray
