#include "render/variant.hpp"

#include <algorithm>

#include "render/scene_buffers.hpp"
#include "renderFewPrimitivesSpirv.spv.h"
#include "renderFromStorageSpirv.spv.h"
#include "renderSpirv.spv.h"

namespace lavaray {
namespace {

// A user's shader reads texels.
bool readsStorage(const vulkan::Device& device, const GpuScene& scene, const RenderSettings& settings) {
  if (!settings.shader.empty()) return false;
  return settings.sceneInStorage || sceneUse(device, scene) == vulkan::BufferUse::kStorage;
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

std::vector<std::uint32_t> specialization(const GpuScene& scene, const RenderSettings& settings) {
  std::vector<std::uint32_t> values = specializationFor(scene);
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
bool skipsEmptyTiles(const GpuScene& scene, const RenderSettings& settings) {
  if (!settings.specialized || takesCenters(settings) || !settings.shader.empty()) return false;
  return scene.planes.empty() && !scene.hasFewPrimitives;
}

// An upper bound for one work item.
std::uint64_t shadowRays(const PipelineVariant& variant, const GpuScene& scene) {
  const std::uint64_t directions = scene.hasSphericalLights ? gpu::kClampedLightDirections : 1;
  return std::uint64_t{gpu::kMaxSamplesPerItem} * directions * variant.lights *
         (1 + std::uint64_t{variant.maxDepth});
}

}  // namespace

std::span<const std::uint32_t> shaderOf(const RenderSettings& settings, bool hasFewPrimitives) {
  if (!settings.shader.empty()) return settings.shader;
  if (hasFewPrimitives && settings.specialized) return renderFewPrimitivesSpirv;
  return renderSpirv;
}

std::vector<std::uint32_t> specializationFor(const GpuScene& scene) {
  std::vector<std::uint32_t> values(gpu::kSpecCount);
  values[gpu::kSpecHasSpheres] = scene.hasSpheres ? 1 : 0;
  values[gpu::kSpecHasTriangles] = scene.hasTriangles ? 1 : 0;
  values[gpu::kSpecHasCornerNormals] = scene.hasCornerNormals ? 1 : 0;
  values[gpu::kSpecPlaneCount] = static_cast<std::uint32_t>(scene.planes.size());
  values[gpu::kSpecLightCount] = static_cast<std::uint32_t>(scene.lights.size());
  values[gpu::kSpecHasMirrors] = scene.hasMirrors ? 1 : 0;
  values[gpu::kSpecHasSphericalLights] = scene.hasSphericalLights ? 1 : 0;
  if (scene.hasFewPrimitives) {
    const auto isSphere = [](const gpu::Primitive& primitive) {
      return primitive.kind == gpu::kPrimitiveSphere;
    };
    const auto spheres = std::ranges::count_if(scene.primitives, isSphere);
    values[gpu::kSpecFewSpheres] = static_cast<std::uint32_t>(spheres);
    values[gpu::kSpecFewTriangles] =
        static_cast<std::uint32_t>(scene.primitives.size()) - values[gpu::kSpecFewSpheres];
  }
  // The traversal's stack holds nodes above the one that it is at.
  values[gpu::kSpecStackSize] = std::max(scene.bvhDepth, 2U) - 1U;
  return values;
}

PipelineVariant chooseVariant(const vulkan::Device& device, const GpuScene& scene,
                              const RenderSettings& settings) {
  const bool inStorage = readsStorage(device, scene, settings);
  PipelineVariant variant;
  variant.shader = inStorage ? renderFromStorageSpirv : shaderOf(settings, scene.hasFewPrimitives);
  variant.sceneUse = inStorage ? vulkan::BufferUse::kStorage : vulkan::BufferUse::kTexels;
  variant.specialization = specialization(scene, settings);
  if (tracesLights(settings.view)) variant.lights = static_cast<std::uint32_t>(scene.lights.size());
  if (scene.hasMirrors && tracesMirrors(settings.view)) variant.maxDepth = settings.maxDepth;
  variant.skipsEmptyTiles = skipsEmptyTiles(scene, settings);
  variant.finishesItems =
      settings.specialized && shadowRays(variant, scene) <= gpu::kMaxShadowRaysPerDispatch;
  return variant;
}

}  // namespace lavaray
