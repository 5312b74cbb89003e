#pragma once

#include <cstdio>

#include "app/report.hpp"

namespace lavaray {

// Everything of --stats, the times included, as one JSON object; the README has its schema. Whether all was
// written is for the owner of the stream to check.
void writeJsonStatistics(std::FILE* stream, const Scene& scene, const GpuScene& gpuScene,
                         const vulkan::Device& device, const RenderStatistics& result,
                         const StepTimes& times);

}  // namespace lavaray
