#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh/gpu_scene.hpp"
#include "render/settings.hpp"
#include "vulkan/buffer.hpp"

namespace lavaray {

// The pipeline that a render runs: it holds no code for what neither the scene nor the settings need.
struct PipelineVariant {
  std::span<const std::uint32_t> shader;      // SPIR-V
  vulkan::BufferUse sceneUse;                 // how it reads the scene
  std::vector<std::uint32_t> specialization;  // by gpu::kSpec...
  std::uint32_t lights = 0;                   // that it traces shadow rays to
  std::uint32_t maxDepth = 0;                 // mirror bounces
  // Tiles of the picture in which nothing can be seen are skipped, and so are not traced.
  bool skipsEmptyTiles = false;
  // Without it an item may be left half done and resumed, which takes a buffer more (gpu::kSpecResumable).
  // Where it is set, and a device ends an item's loops all the same, the resumable pipeline takes over.
  bool finishesItems = false;
};

PipelineVariant chooseVariant(const vulkan::Device& device, const GpuScene& scene,
                              const RenderSettings& settings);

// The SPIR-V that a render with these settings runs for a scene with few primitives, or more, where its
// arrays are not too large for texels.
std::span<const std::uint32_t> shaderOf(const RenderSettings& settings, bool hasFewPrimitives);

// The specialization constants that say what the scene has; all others are 0.
std::vector<std::uint32_t> specializationFor(const GpuScene& scene);

}  // namespace lavaray
