#include "render/variant.hpp"

#include <algorithm>
#include <cmath>

#include "render/scene_buffers.hpp"
#include "render/tuning.hpp"
#include "render2RaysSpirv.spv.h"
#include "render4RaysSpirv.spv.h"
#include "renderFewPrimitivesSpirv.spv.h"
#include "renderFromStorage2RaysSpirv.spv.h"
#include "renderFromStorage4RaysSpirv.spv.h"
#include "renderFromStorageSpirv.spv.h"
#include "renderSpirv.spv.h"

namespace lavaray {
namespace {

// What a driver takes longer, in seconds, to read the module of two rays than that of one, and that of four
// than that of two, be it only to find that it has compiled it before. And what that saves: with two, for
// each ray and each doubling of the number of primitives; with four, for each ray again. As measured with
// lavapipe (tools/bench_speed/traversal.md).
constexpr double kSecondsForTwo = 0.08;
constexpr double kSecondsForFour = 0.16;
constexpr double kSavedByTwo = 4e-9;
constexpr double kSavedByFour = 16e-9;

bool isTraversed(const SceneFeatures& scene) {
  return scene.primitiveCount > 0 && !scene.hasFewPrimitives;
}

// A user's shader reads texels.
bool readsStorage(const RenderSettings& settings, vulkan::BufferUse sceneUse, const SceneFeatures& scene,
                  const Tuning& tuning) {
  if (!settings.shader.empty()) return false;
  return settings.sceneInStorage || sceneUse == vulkan::BufferUse::kStorage ||
         (tuning.sceneInStorage && isTraversed(scene));
}

// Samples of a pixel. Where they follow a target error, roughly the median of bench-error's scenes, which
// differ by a factor of ten.
double samplesOf(const RenderSettings& settings) {
  if (settings.targetError)
    return std::clamp(0.03 / *settings.targetError, 2.0, static_cast<double>(settings.maxSamples));
  return sampleRange(settings).end - sampleRange(settings).first;
}

gpu::uint samplingOf(const RenderSettings& settings) {
  if (takesCenters(settings)) return gpu::kSamplingCenter;
  return settings.sampler == Sampler::kSobol ? gpu::kSamplingSobol : gpu::kSamplingRandom;
}

// As if the scene had everything.
void generalize(std::vector<std::uint32_t>& values) {
  for (const gpu::uint feature : {gpu::kSpecHasSpheres, gpu::kSpecHasTriangles, gpu::kSpecHasCornerNormals,
                                  gpu::kSpecHasMirrors, gpu::kSpecHasSphericalLights}) {
    values[feature] = 1;
  }
  values[gpu::kSpecStackSize] = gpu::kMaxBvhDepth;
}

// The stack holds the rest of every node on the path, that of the node above the root included.
std::uint32_t stackFor(std::uint32_t bvhDepth) {
  return std::max(bvhDepth, 1U);
}

std::vector<std::uint32_t> describe(const SceneFeatures& scene) {
  std::vector<std::uint32_t> values(gpu::kSpecCount);
  values[gpu::kSpecHasSpheres] = scene.hasSpheres ? 1 : 0;
  values[gpu::kSpecHasTriangles] = scene.hasTriangles ? 1 : 0;
  values[gpu::kSpecHasCornerNormals] = scene.hasCornerNormals ? 1 : 0;
  values[gpu::kSpecPlaneCount] = scene.planeCount;
  values[gpu::kSpecLightCount] = scene.lightCount;
  values[gpu::kSpecHasMirrors] = scene.hasMirrors ? 1 : 0;
  values[gpu::kSpecHasSphericalLights] = scene.hasSphericalLights ? 1 : 0;
  if (scene.hasFewPrimitives) {
    values[gpu::kSpecFewSpheres] = static_cast<std::uint32_t>(scene.sphereCount);
    values[gpu::kSpecFewTriangles] = static_cast<std::uint32_t>(scene.primitiveCount - scene.sphereCount);
  }
  return values;
}

std::vector<std::uint32_t> specialization(const SceneFeatures& scene, std::uint32_t bvhDepth,
                                          const RenderSettings& settings) {
  std::vector<std::uint32_t> values = describe(scene);
  values[gpu::kSpecStackSize] = std::max(stackFor(bvhDepth), settings.minStackSize);
  values[gpu::kSpecSampling] = samplingOf(settings);
  values[gpu::kSpecCountRays] = settings.countRays ? 1 : 0;
  values[gpu::kSpecHasEntryNodes] = settings.specialized && !scene.hasFewPrimitives ? 1 : 0;
  if (!settings.specialized) generalize(values);
  values[gpu::kSpecView] = tracedView(settings.view);
  values[gpu::kSpecAsData] = settings.asData ? 1 : 0;
  if (!tracesMirrors(settings.view)) values[gpu::kSpecHasMirrors] = 0;
  if (!tracesLights(settings.view)) {
    values[gpu::kSpecLightCount] = 0;
    values[gpu::kSpecHasSphericalLights] = 0;
  }
  return values;
}

// Where there is nothing a sample is black, though a user's shader may see it differently. One sample of each
// pixel is as fast as a list of the pixels where something is.
bool skipsEmptyTiles(const SceneFeatures& scene, const RenderSettings& settings) {
  if (!settings.specialized || takesCenters(settings) || !settings.shader.empty()) return false;
  return scene.planeCount == 0 && !scene.hasFewPrimitives;
}

// By the shadow rays of one work item. Most samples look at a spherical light in a single direction.
Expectation finishesItems(const PipelineVariant& variant, const SceneFeatures& scene) {
  const std::uint64_t usual =
      std::uint64_t{gpu::kMaxSamplesPerItem} * variant.lights * (1 + std::uint64_t{variant.maxDepth});
  const std::uint64_t most = usual * (scene.hasSphericalLights ? gpu::kClampedLightDirections : 1);
  if (most <= gpu::kMaxShadowRaysPerDispatch) return Expectation::kCertain;
  return usual <= gpu::kMaxShadowRaysPerDispatch ? Expectation::kLikely : Expectation::kNo;
}

// The more rays, the faster, but the longer a driver takes for the module. Rays search a hierarchy together,
// and only a single ray's tests are counted, only a single path is resumed.
std::uint32_t raysPerLane(const PipelineVariant& variant, const SceneFeatures& scene,
                          const RenderSettings& settings, const Tuning& tuning) {
  if (!isTraversed(scene) || variant.finishesItems == Expectation::kNo || !settings.shader.empty() ||
      settings.view == View::kCost)
    return 1;
  if (settings.raysPerLane) return *settings.raysPerLane;
  const double rays = estimatedRays(variant.lights, settings);
  const double doublings = std::log2(static_cast<double>(scene.primitiveCount));
  if (rays * doublings * kSavedByTwo < kSecondsForTwo) return 1;
  return std::min(tuning.raysPerLane, rays * kSavedByFour < kSecondsForFour ? 2U : 4U);
}

// For more than one ray.
std::span<const std::uint32_t> moduleOf(std::uint32_t raysPerLane, bool inStorage) {
  if (raysPerLane == 2) {
    if (inStorage) return renderFromStorage2RaysSpirv;
    return render2RaysSpirv;
  }
  if (inStorage) return renderFromStorage4RaysSpirv;
  return render4RaysSpirv;
}

}  // namespace

std::span<const std::uint32_t> shaderOf(const RenderSettings& settings, bool hasFewPrimitives) {
  if (!settings.shader.empty()) return settings.shader;
  if (hasFewPrimitives && settings.specialized) return renderFewPrimitivesSpirv;
  return renderSpirv;
}

double estimatedRays(std::uint32_t lights, const RenderSettings& settings) {
  return static_cast<double>(settings.crop.pixels()) * samplesOf(settings) * (1.0 + lights);
}

std::vector<std::uint32_t> specializationFor(const GpuScene& scene) {
  std::vector<std::uint32_t> values = describe(scene);
  values[gpu::kSpecStackSize] = stackFor(scene.bvhDepth);
  return values;
}

PipelineVariant chooseVariant(const vulkan::Device& device, const GpuScene& scene,
                              const RenderSettings& settings) {
  return chooseVariant(device, scene, scene.bvhDepth, sceneUse(device, scene), settings);
}

PipelineVariant chooseVariant(const vulkan::Device& device, const SceneFeatures& scene,
                              std::uint32_t bvhDepth, vulkan::BufferUse sceneUse,
                              const RenderSettings& settings) {
  PipelineVariant variant;
  const Tuning tuning = settings.tuning.value_or(usualTuning(device.description().isCpu));
  const bool inStorage = readsStorage(settings, sceneUse, scene, tuning);
  variant.sceneUse = inStorage ? vulkan::BufferUse::kStorage : vulkan::BufferUse::kTexels;
  variant.specialization = specialization(scene, bvhDepth, settings);
  if (tracesLights(settings.view)) variant.lights = scene.lightCount;
  if (scene.hasMirrors && tracesMirrors(settings.view)) variant.maxDepth = settings.maxDepth;
  variant.skipsEmptyTiles = skipsEmptyTiles(scene, settings);
  if (settings.specialized) variant.finishesItems = finishesItems(variant, scene);
  variant.specialization[gpu::kSpecResumable] = variant.finishesItems == Expectation::kNo ? 1 : 0;
  variant.raysPerLane = raysPerLane(variant, scene, settings, tuning);
  variant.resumable = inStorage ? renderFromStorageSpirv : shaderOf(settings, scene.hasFewPrimitives);
  variant.shader = variant.raysPerLane == 1 ? variant.resumable : moduleOf(variant.raysPerLane, inStorage);
  return variant;
}

}  // namespace lavaray
