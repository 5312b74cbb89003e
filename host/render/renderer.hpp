#pragma once

#include <atomic>
#include <cstdint>

#include "core/flatten.hpp"
#include "image/image.hpp"
#include "render/settings.hpp"
#include "render/tracer.hpp"

namespace lavaray {

enum class StopReason {
  kFinished,    // all samples are taken, or the target error is reached
  kMaxSamples,  // every pixel that wants more samples has as many as allowed
  kTimeLimit,
  kInterrupted,
};

struct RenderResult {
  Image image;  // of the crop's size; black where no sample was taken
  StopReason stopReason = StopReason::kFinished;
  double estimatedError = 0.0;      // RMSE, where there was a target
  std::uint32_t mostSamples = 1;    // of a pixel
  std::uint64_t skippedPixels = 0;  // known to be black without a sample
  TraceCounts counts;
  std::size_t deviceBytes = 0;
};

// Renders the scene as the settings say, looking at `interrupted` about ten times a second.
// Throws Error(kDevice) where the device fails or cannot finish a ray.
RenderResult render(vulkan::Device& device, const GpuScene& scene, const Camera& camera,
                    const RenderSettings& settings, const std::atomic<bool>& interrupted);

}  // namespace lavaray
