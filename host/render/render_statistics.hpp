#pragma once

#include <cstddef>
#include <cstdint>

#include <lavaray/types.h>

#include "render/settings.hpp"
#include "render/trace_counts.hpp"
#include "vulkan/activity.hpp"

namespace lavaray {

using v0::StopReason;

const char* stopReasonName(StopReason reason);

// What a render did, and why it stopped.
struct RenderStatistics {
  StopReason stopReason = StopReason::kFinished;
  double samplesPerPixel = 0.0;     // mean over pixels that are not skipped, including samples of a film
  double estimatedError = 0.0;      // RMSE, where there was a target
  std::uint32_t maxSamples = 1;     // of a pixel
  std::uint64_t skippedPixels = 0;  // known to be black without a sample
  TraceCounts counts;               // of this process
  vulkan::Activity activity;        // if times were recorded
  std::size_t deviceBytes = 0;
  Tuning tuning;                // the way that was traced in
  double largestMeasure = 0.0;  // of a pixel, where the view is a measure: that is shown as 1
};

}  // namespace lavaray
