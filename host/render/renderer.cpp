#include "render/renderer.hpp"

#include <algorithm>
#include <chrono>
#include <memory>

#include "render/center_sampling.hpp"
#include "render/covered_part.hpp"
#include "render/fixed_sampling.hpp"
#include "render/small_objects.hpp"
#include "render/target_sampling.hpp"

namespace lavaray {
namespace {

using Clock = std::chrono::steady_clock;

std::uint64_t pixelsOf(const Rectangle& part) {
  return static_cast<std::uint64_t>(part.x1 - part.x0) * static_cast<std::uint64_t>(part.y1 - part.y0);
}

// The part of the crop to trace; all else is black. The plan for a target error and the other views are about
// all pixels.
Rectangle tracedPart(const GpuScene& scene, const Camera& camera, const RenderSettings& settings) {
  if (settings.targetError || settings.view != View::kColor || !settings.specialized) return settings.crop;
  return coveredPart(scene, camera, settings);
}

SampleRange sampleRange(const RenderSettings& settings) {
  return {settings.firstSample, settings.samples};
}

std::unique_ptr<Sampling> makeSampling(const GpuScene& scene, const Camera& camera,
                                       const RenderSettings& settings) {
  const Rectangle& part = settings.crop;
  if (settings.targetError) {
    return std::make_unique<TargetSampling>(AdaptiveSampling(part.x1 - part.x0, part.y1 - part.y0,
                                                             *settings.targetError, settings.maxSamples,
                                                             pixelsOfSmallObjects(scene, camera, settings)));
  }
  if (settings.samples == 1) return std::make_unique<CenterSampling>(pixelsOf(part), settings.view);
  return std::make_unique<FixedSampling>(pixelsOf(part), sampleRange(settings), settings.view);
}

// About the most items of a pass.
std::uint64_t mostItems(const RenderSettings& settings) {
  const std::uint64_t pixels = pixelsOf(settings.crop);
  if (settings.targetError) return 2 * pixels;
  return FixedSampling::mostItems(pixels, sampleRange(settings));
}

// One render of settings.crop, of which it traces the part that can show anything.
class Render : public RenderInProgress {
 public:
  Render(vulkan::Device& device, const GpuScene& scene, const Camera& camera, const RenderSettings& settings)
      : crop_(settings.crop), settings_(settings) {
    settings_.crop = tracedPart(scene, camera, settings);
    if (pixelsOf(settings_.crop) == 0) return;
    sampling_ = makeSampling(scene, camera, settings_);
    tracer_.emplace(device, scene, camera, settings_, mostItems(settings_));
  }

  RenderResult run(const Proceed& proceed) {
    RenderResult result;
    if (sampling_) result.stopReason = trace(proceed);
    result.image = image();
    result.skippedPixels = pixelsOf(crop_) - pixelsOf(settings_.crop);
    if (!sampling_) return result;
    result.estimatedError = sampling_->estimatedError();
    result.mostSamples = mostSamples();
    result.counts = tracer_->counts();
    result.deviceBytes = tracer_->deviceBytes();
    return result;
  }

  [[nodiscard]] double shareDone() const override { return sampling_->shareDone(); }
  [[nodiscard]] double samplesPerPixel() const override {
    return static_cast<double>(tracer_->counts().samples) / static_cast<double>(pixelsOf(crop_));
  }
  [[nodiscard]] double estimatedError() const override { return sampling_->estimatedError(); }

  [[nodiscard]] Image image() const override {
    const Rectangle& part = settings_.crop;
    Image traced{part.x1 - part.x0, part.y1 - part.y0, std::vector<float>(3 * pixelsOf(part))};
    const std::uint32_t most = settings_.view == View::kSamples ? mostSamples() : 1;
    for (std::uint64_t pixel = 0; pixel < pixelsOf(part); ++pixel) {
      const glm::vec3 color = shown(pixel, most);
      for (int channel = 0; channel < 3; ++channel) traced.rgb[3 * pixel + channel] = color[channel];
    }
    if (isMeasure(settings_.view)) normalize(traced);
    Image whole{crop_.x1 - crop_.x0, crop_.y1 - crop_.y0, {}};
    if (whole.width == traced.width && whole.height == traced.height) return traced;
    whole.rgb.resize(3 * pixelsOf(crop_));
    paste(traced, part.x0 - crop_.x0, part.y0 - crop_.y0, whole);
    return whole;
  }

 private:
  StopReason trace(const Proceed& proceed) {
    const Clock::time_point start = Clock::now();
    StopReason reason = StopReason::kFinished;
    const auto stop = [&] {
      const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
      if (!proceed(*this)) {
        reason = StopReason::kInterrupted;
      } else if (settings_.timeLimitSeconds && seconds >= *settings_.timeLimitSeconds) {
        reason = StopReason::kTimeLimit;
      }
      return reason != StopReason::kFinished;
    };
    while (sampling_->itemsDone() < sampling_->passItems() || sampling_->startPass()) {
      const bool finished = tracer_->run(
          sampling_->itemsDone(), sampling_->passItems(),
          [this](std::uint64_t index) { return sampling_->item(index); },
          [this](std::uint64_t /*index*/, const gpu::WorkResult& result) { sampling_->add(result); }, stop);
      if (!finished) return reason;
    }
    return sampling_->reachedGoal() ? StopReason::kFinished : StopReason::kMaxSamples;
  }

  [[nodiscard]] std::uint32_t mostSamples() const {
    std::uint32_t most = 1;
    const std::uint64_t pixels = pixelsOf(settings_.crop);
    for (std::uint64_t pixel = 0; pixel < pixels; ++pixel) most = std::max(most, sampling_->samples(pixel));
    return most;
  }

  // What the view shows of a pixel.
  [[nodiscard]] glm::vec3 shown(std::uint64_t pixel, std::uint32_t most) const {
    switch (settings_.view) {
      case View::kSamples:
        return glm::vec3(static_cast<float>(sampling_->samples(pixel)) / static_cast<float>(most));
      case View::kError:
        return glm::vec3(static_cast<float>(std::min(1.0, sampling_->estimatedError(pixel))));
      default:
        return sampling_->value(pixel);
    }
  }

  Rectangle crop_;                      // of the image that is asked for
  RenderSettings settings_;             // their crop is the part that is traced
  std::unique_ptr<Sampling> sampling_;  // none where nothing is traced
  std::optional<Tracer> tracer_;
};

}  // namespace

RenderResult render(vulkan::Device& device, const GpuScene& scene, const Camera& camera,
                    const RenderSettings& settings, const Proceed& proceed) {
  return Render(device, scene, camera, settings).run(proceed);
}

}  // namespace lavaray
