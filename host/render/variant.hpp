#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh/gpu_scene.hpp"
#include "render/settings.hpp"
#include "vulkan/buffer.hpp"

namespace lavaray {

enum class Expectation { kNo, kLikely, kCertain };

// The pipeline that a render runs: it holds no code for what neither the scene nor the settings need.
struct PipelineVariant {
  std::span<const std::uint32_t> shader;      // SPIR-V
  std::span<const std::uint32_t> resumable;   // the same of single rays, which can be resumed
  vulkan::BufferUse sceneUse;                 // how it reads the scene
  std::vector<std::uint32_t> specialization;  // by gpu::kSpec...
  std::uint32_t lights = 0;                   // to which it traces shadow rays
  std::uint32_t maxDepth = 0;                 // mirror bounces
  std::uint32_t raysPerLane = 1;              // that an invocation traces together
  // Tiles of the picture that can show nothing are not traced.
  bool skipsEmptyTiles = false;
  // Whether a dispatch finishes its items. A pipeline that can leave them half done and resume them takes
  // another buffer (gpu::kSpecResumable); it does those that the other one gives up on, or all of them.
  Expectation finishesItems = Expectation::kNo;
};

PipelineVariant chooseVariant(const vulkan::Device& device, const GpuScene& scene,
                              const RenderSettings& settings);

// The same for a scene whose hierarchy has that depth, and whose arrays are read in that way.
PipelineVariant chooseVariant(const vulkan::Device& device, const SceneFeatures& scene,
                              std::uint32_t bvhDepth, vulkan::BufferUse sceneUse,
                              const RenderSettings& settings);

// The SPIR-V that a render with these settings runs if the scene's arrays are small enough for texels.
std::span<const std::uint32_t> shaderOf(const RenderSettings& settings, bool hasFewPrimitives);

// Roughly the rays that a render of a scene with so many lights traces.
double estimatedRays(std::uint32_t lights, const RenderSettings& settings);

// The specialization constants that say what the scene has; all others are 0.
std::vector<std::uint32_t> specializationFor(const GpuScene& scene);

}  // namespace lavaray
