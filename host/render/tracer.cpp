#include "render/tracer.hpp"

#include <algorithm>
#include <chrono>
#include <string>

#include "base/errors.hpp"
#include "render/scene_buffers.hpp"
#include "render/tile_starts.hpp"
#include "renderFewPrimitivesSpirv.spv.h"
#include "renderFromStorageSpirv.spv.h"
#include "renderSpirv.spv.h"

namespace lavaray {
namespace {

// A piece never has more items, so that the buffers stay small whatever the image's size.
constexpr std::uint64_t kMaxPieceItems = std::uint64_t{1} << 20U;
constexpr double kFirstPieceRays = 1U << 15U;
constexpr double kPieceSeconds = 0.1;

gpu::DispatchConstants dispatchConstants(const Camera& camera, const RenderSettings& settings,
                                         const GpuScene& scene, std::size_t filterSize) {
  const ImageSize plane = imageSize(camera).value();
  gpu::DispatchConstants constants{};
  constants.pixelSize =
      glm::dvec2(plane.width, plane.height) / glm::dvec2(settings.size.width, settings.size.height);
  constants.halfImage = glm::dvec2(plane.width, plane.height) / 2.0;
  constants.focalLength = static_cast<float>(camera.focalLength);
  constants.cropX = static_cast<gpu::uint>(settings.crop.x0);
  constants.cropY = static_cast<gpu::uint>(settings.crop.y0);
  constants.cropWidth = static_cast<gpu::uint>(settings.crop.x1 - settings.crop.x0);
  constants.seed = settings.seed;
  constants.maxDepth = scene.hasMirrors && tracesMirrors(settings.view) ? settings.maxDepth : 0;
  constants.filterSize = static_cast<gpu::uint>(filterSize);
  return constants;
}

bool takesCenterOnly(const RenderSettings& settings) {
  return settings.samples == 1 && !settings.targetError;
}

std::vector<std::uint32_t> specialization(const GpuScene& scene, const RenderSettings& settings) {
  std::vector<std::uint32_t> values = specializationFor(scene);
  values[gpu::kSpecSampling] = takesCenterOnly(settings)             ? gpu::kSamplingCenter
                               : settings.sampler == Sampler::kSobol ? gpu::kSamplingSobol
                                                                     : gpu::kSamplingRandom;
  values[gpu::kSpecCountRays] = settings.countRays ? 1 : 0;
  values[gpu::kSpecHasEntryNodes] = settings.specialized && !scene.hasFewPrimitives ? 1 : 0;
  if (!settings.specialized) {
    for (const gpu::uint feature : {gpu::kSpecHasSpheres, gpu::kSpecHasTriangles, gpu::kSpecHasCornerNormals,
                                    gpu::kSpecHasMirrors, gpu::kSpecHasSphericalLights}) {
      values[feature] = 1;
    }
    values[gpu::kSpecStackSize] = gpu::kMaxBvhDepth;
  }
  values[gpu::kSpecView] = tracedView(settings.view);
  values[gpu::kSpecAsData] = settings.asData ? 1 : 0;
  if (!tracesMirrors(settings.view)) values[gpu::kSpecHasMirrors] = 0;
  if (!tracesLights(settings.view)) {
    values[gpu::kSpecLightCount] = 0;
    values[gpu::kSpecHasSphericalLights] = 0;
  }
  return values;
}

// Where nothing is, a sample is black, unless a shader of the user's knows better. One sample of each pixel
// is as fast as a list of the pixels where something is.
bool skipsTiles(const GpuScene& scene, const RenderSettings& settings) {
  if (!settings.specialized || takesCenterOnly(settings) || !settings.shader.empty()) return false;
  return scene.planes.empty() && !scene.hasFewPrimitives;
}

}  // namespace

std::span<const std::uint32_t> shaderOf(const RenderSettings& settings, bool hasFewPrimitives) {
  if (!settings.shader.empty()) return settings.shader;
  if (hasFewPrimitives && settings.specialized) return renderFewPrimitivesSpirv;
  return renderSpirv;
}

Tracer::Tracer(vulkan::Device& device, const GpuScene& scene, const Camera& camera,
               const RenderSettings& settings, std::uint64_t items)
    : device_(device),
      centerOnly_(takesCenterOnly(settings)),
      starts_(tileStarts(scene, camera, settings)),
      skipsTiles_(skipsTiles(scene, settings)),
      shader_(shaderOf(settings, scene.hasFewPrimitives)) {
  const std::uint64_t reachable =
      std::min<std::uint64_t>(device.limits().storageBufferRange / sizeof(gpu::WorkState),
                              std::uint64_t{device.limits().workGroupsX} * gpu::kWorkGroupSize);
  capacity_ = static_cast<std::uint32_t>(std::min({kMaxPieceItems, reachable, items}));
  const std::uint64_t lights = tracesLights(settings.view) ? scene.lights.size() : 0;
  pieceItems_ = std::max(double{gpu::kWorkGroupSize}, kFirstPieceRays / static_cast<double>(1 + lights));

  const std::vector<float> filter = filterTable(settings.filter);
  constants_ = dispatchConstants(camera, settings, scene, filter.size());
  // A shader of the user's reads texels.
  const bool inStorage = settings.shader.empty() &&
                         (settings.sceneInStorage || sceneUse(device, scene) == vulkan::BufferUse::kStorage);
  if (inStorage) shader_ = renderFromStorageSpirv;
  const auto use = inStorage ? vulkan::BufferUse::kStorage : vulkan::BufferUse::kTexels;
  buffers_ = uploadScene(device, scene, use);
  if (skipsTiles_) {
    skippedPixels_ = pixelsOfEmptyTiles(
        starts_, {settings.crop.x1 - settings.crop.x0, settings.crop.y1 - settings.crop.y0});
  }
  constants_.tileShift = starts_.shift;
  constants_.tilesAcross = starts_.across;
  buffers_.push_back(
      vulkan::Buffer::uploaded(device, "tiles", use, std::as_bytes(std::span(starts_.groups))));
  const std::vector<float> noTable(4);
  buffers_.push_back(vulkan::Buffer::uploaded(device, "pixel filter", vulkan::BufferUse::kStorage,
                                              std::as_bytes(std::span(filter.empty() ? noTable : filter))));
  const std::size_t workItems = centerOnly_ ? 1 : capacity_;
  buffers_.push_back(vulkan::Buffer::shared(device, "work items", workItems * sizeof(gpu::WorkItem)));
  buffers_.push_back(vulkan::Buffer::shared(device, "results", capacity_ * sizeof(gpu::WorkResult)));
  buffers_.push_back(vulkan::Buffer::shared(device, "unfinished work", sizeof(gpu::WorkState)));
  buffers_.push_back(vulkan::Buffer::shared(device, "dispatch status", sizeof(gpu::DispatchStatus)));
  specialization_ = specialization(scene, settings);
  const std::uint64_t directions = scene.hasSphericalLights ? gpu::kClampedLightDirections : 1;
  const std::uint64_t shadowRays =
      std::uint64_t{gpu::kMaxSamplesPerItem} * directions * lights * (1 + constants_.maxDepth);
  if (settings.specialized && shadowRays <= gpu::kMaxShadowRaysPerDispatch)
    direct_.emplace(makeShader(false));
}

std::size_t Tracer::deviceBytes() const {
  std::size_t bytes = 0;
  for (const vulkan::Buffer& buffer : buffers_) bytes += buffer.size();
  return bytes;
}

bool Tracer::run(std::uint64_t first, std::uint64_t end, const MakeItems& makeItems,
                 const TakeResults& takeResults, const Stop& stop) {
  using Clock = std::chrono::steady_clock;
  while (first < end) {
    if (stop()) return false;
    const auto pieceCount = static_cast<std::uint32_t>(
        std::min({static_cast<std::uint64_t>(pieceItems_), std::uint64_t{capacity_}, end - first}));
    const Clock::time_point start = Clock::now();
    const std::uint32_t traced = makePiece(first, pieceCount, makeItems);
    if (traced > 0) dispatchUntilFinished(traced);
    takePiece(first, pieceCount, takeResults);

    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    // The first piece's time says nothing: drivers compile the shader in it.
    const double factor = isWarm_ ? std::clamp(kPieceSeconds / seconds, 0.25, 4.0) : 4.0;
    pieceItems_ =
        std::clamp(pieceItems_ * factor, double{gpu::kWorkGroupSize}, static_cast<double>(kMaxPieceItems));
    isWarm_ = true;
    first += pieceCount;
  }
  return true;
}

// Returns how many items there are to trace.
std::uint32_t Tracer::makePiece(std::uint64_t first, std::uint32_t count, const MakeItems& makeItems) {
  constants_.firstPixel = static_cast<gpu::uint>(first);
  if (centerOnly_) {
    counts_.samples += count;
    return count;
  }
  const std::span items(reinterpret_cast<gpu::WorkItem*>(buffers_[gpu::kBindingWork].bytes()), count);
  makeItems(first, items);
  places_.clear();
  std::uint32_t traced = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (skips(items[i].pixel)) {
      counts_.skippedSamples += items[i].count;
      continue;
    }
    counts_.samples += items[i].count;
    if (skipsTiles_) places_.push_back(i);
    items[traced++] = items[i];
  }
  return traced;
}

void Tracer::takePiece(std::uint64_t first, std::uint32_t count, const TakeResults& takeResults) {
  const auto* results = reinterpret_cast<const gpu::WorkResult*>(buffers_[gpu::kBindingResults].bytes());
  if (skipsTiles_) {
    allResults_.assign(count, {});
    for (const std::uint32_t place : places_) allResults_[place] = *results++;
    results = allResults_.data();
  }
  takeResults(first, {results, count});
}

vulkan::ComputeShader Tracer::makeShader(bool resumable) {
  if (resumable) {
    direct_.reset();  // it is bound to the buffer that is replaced here, and this scene needs the other one
    buffers_[gpu::kBindingStates] =
        vulkan::Buffer::shared(device_, "unfinished work", capacity_ * sizeof(gpu::WorkState));
  }
  specialization_[gpu::kSpecResumable] = resumable ? 1 : 0;
  return {device_, shader_, specialization_, buffers_, sizeof constants_};
}

gpu::DispatchStatus Tracer::dispatch(vulkan::ComputeShader& shader, std::uint32_t count, gpu::uint mode) {
  auto* status = reinterpret_cast<gpu::DispatchStatus*>(buffers_[gpu::kBindingStatus].bytes());
  *status = {};
  constants_.itemCount = count;
  constants_.mode = mode;
  shader.dispatch((count + gpu::kWorkGroupSize - 1) / gpu::kWorkGroupSize,
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
