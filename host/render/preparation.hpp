#pragma once

#include <cstddef>
#include <cstdint>

#include "bvh/scene_features.hpp"
#include "render/settings.hpp"
#include "vulkan/device.hpp"

namespace lavaray {

// Whether to prepare a pipeline for a render while the hierarchy is built. It is not worth it where that
// takes no time, nor where so many rays are traced that unused entries of the stack take more time than is
// saved.
bool isWorthPreparing(const SceneFeatures& scene, const RenderSettings& settings);

// Entries of the traversal's stack that seldom are too few for a hierarchy over so many primitives.
std::uint32_t expectedStackSize(std::size_t primitives);

// Has the device's pipelines make the one that a render of such a scene is expected to run: with
// settings.minStackSize entries, which the render's settings then have, too. A render that needs more makes
// its own. What fails here fails the render, if that asks for the same pipeline.
void preparePipeline(vulkan::Device& device, const SceneFeatures& scene, const RenderSettings& settings);

}  // namespace lavaray
