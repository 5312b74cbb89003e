#pragma once

#include <cstdint>
#include <functional>

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

// A render that is under way.
class RenderInProgress {
 public:
  virtual ~RenderInProgress() = default;
  [[nodiscard]] virtual double shareDone() const = 0;        // in [0, 1]; estimated where there is a target
  [[nodiscard]] virtual double samplesPerPixel() const = 0;  // in the mean
  [[nodiscard]] virtual double estimatedError() const = 0;   // RMSE, where there is a target, else 0
  [[nodiscard]] virtual Image image() const = 0;             // as far as it is known
};

// Is called between two pieces of work, about ten times a second, and returns whether to go on.
using Proceed = std::function<bool(const RenderInProgress&)>;

// Renders the scene as the settings say. Throws Error(kDevice) where the device fails or cannot finish a ray.
RenderResult render(vulkan::Device& device, const GpuScene& scene, const Camera& camera,
                    const RenderSettings& settings, const Proceed& proceed);

}  // namespace lavaray
