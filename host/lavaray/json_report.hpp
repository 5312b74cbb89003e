#pragma once

#include <cstdio>

#include "lavaray/report.hpp"
#include "scene/camera.hpp"

namespace lavaray {

// One JSON object each; the README has its schema. `size` is that of the whole picture. Whether all was
// written is for the owner of the stream to check.

// What --check says, and the picture's size.
void writeJsonCheck(std::FILE* stream, const Scene& scene, const ImageSize& size);

// Everything of --stats, the times included.
void writeJsonStatistics(std::FILE* stream, const Scene& scene, const ImageSize& size,
                         const GpuScene& gpuScene, const vulkan::Device& device,
                         const RenderStatistics& result, const StepTimes& times);

}  // namespace lavaray
