#include "render/renderer.hpp"

#include <algorithm>
#include <chrono>

#include "render/adaptive.hpp"
#include "render/covered_part.hpp"
#include "render/pixel_sum.hpp"
#include "render/small_objects.hpp"

namespace lavaray {
namespace {

using Clock = std::chrono::steady_clock;

// A fixed number of samples is taken in rounds of so many a pixel at most, so that a render that is stopped
// has about the same number everywhere. The first rounds are small: a pixel without a sample is black.
constexpr std::uint32_t kRoundSamples = 64;

class Render {
 public:
  Render(vulkan::Device& device, const GpuScene& scene, const Camera& camera, const RenderSettings& settings,
         const std::atomic<bool>& interrupted)
      : scene_(scene),
        camera_(camera),
        settings_(settings),
        interrupted_(interrupted),
        width_(settings.crop.x1 - settings.crop.x0),
        height_(settings.crop.y1 - settings.crop.y0),
        pixels_(static_cast<std::uint64_t>(width_) * static_cast<std::uint64_t>(height_)),
        tracer_(device, scene, camera, settings, pixels_ * itemsPerPixel()) {
    result_.image = {width_, height_, std::vector<float>(3 * pixels_)};
  }

  RenderResult run() {
    if (settings_.targetError) {
      renderToTarget();
    } else if (settings_.samples == 1) {
      renderCenters();
    } else {
      renderSamples();
    }
    if (isMeasure(settings_.view)) normalize(result_.image);
    result_.counts = tracer_.counts();
    result_.deviceBytes = tracer_.deviceBytes();
    return std::move(result_);
  }

 private:
  // Work items of a pixel in one round.
  [[nodiscard]] std::uint64_t itemsPerPixel() const {
    if (settings_.targetError) return 2;
    return (std::min(settings_.samples, kRoundSamples) + gpu::kMaxSamplesPerItem - 1) /
           gpu::kMaxSamplesPerItem;
  }

  bool shouldStop() {
    if (interrupted_) {
      result_.stopReason = StopReason::kInterrupted;
      return true;
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    if (settings_.timeLimitSeconds && seconds >= *settings_.timeLimitSeconds) {
      result_.stopReason = StopReason::kTimeLimit;
      return true;
    }
    return false;
  }

  void setPixel(std::uint64_t pixel, const glm::vec3& color) {
    for (int channel = 0; channel < 3; ++channel) result_.image.rgb[3 * pixel + channel] = color[channel];
  }

  void renderCenters() {
    tracer_.run(
        pixels_, {},
        [&](std::uint64_t pixel, const gpu::WorkResult& result) {
          if (settings_.view == View::kSamples) {
            setPixel(pixel, glm::vec3(1.0F));
          } else if (isMeasure(settings_.view)) {
            setPixel(pixel, glm::vec3(static_cast<float>(measure(settings_.view, result.sum))));
          } else {
            setPixel(pixel, result.sum);
          }
        },
        [&] { return shouldStop(); });
  }

  void renderSamples() {
    std::vector<PixelSum> sums(pixels_);
    // Results come in the order of their items, so that these sums need no fixed point, which has bounds.
    std::vector<glm::dvec3> measured(isMeasure(settings_.view) ? pixels_ : 0);
    std::uint32_t done = 0;
    while (done < settings_.samples) {
      const std::uint32_t round = std::clamp(done, gpu::kMaxSamplesPerItem, kRoundSamples);
      const std::uint32_t samples = std::min(round, settings_.samples - done);
      const std::uint32_t items = (samples + gpu::kMaxSamplesPerItem - 1) / gpu::kMaxSamplesPerItem;
      const auto makeItem = [&](std::uint64_t index) {
        const auto offset = static_cast<std::uint32_t>(index % items) * gpu::kMaxSamplesPerItem;
        return gpu::WorkItem{static_cast<gpu::uint>(index / items), 0, done + offset,
                             std::min(gpu::kMaxSamplesPerItem, samples - offset)};
      };
      const auto takeResult = [&](std::uint64_t index, const gpu::WorkResult& result) {
        const std::uint64_t pixel = index / items;
        if (!measured.empty()) measured[pixel] += glm::dvec3(result.sum);
        sums[pixel].add(measured.empty() ? result.sum : glm::vec3(0.0F), makeItem(index).count);
      };
      if (!tracer_.run(pixels_ * items, makeItem, takeResult, [&] { return shouldStop(); })) break;
      done += samples;
    }
    const auto color = [&](std::uint64_t pixel) {
      if (measured.empty()) return glm::vec3(sums[pixel].mean());
      return glm::vec3(static_cast<float>(measure(settings_.view, measured[pixel])));
    };
    showPixels(
        color, [&](std::uint64_t pixel) { return sums[pixel].samples(); },
        // One sequence does not tell its error.
        [](std::uint64_t) { return 0.0; });
  }

  void renderToTarget() {
    AdaptiveSampling adaptive(width_, height_, *settings_.targetError, settings_.maxSamples,
                              pixelsOfSmallObjects(scene_, camera_, settings_));
    for (;;) {
      const std::vector<gpu::WorkItem> items = adaptive.nextItems();
      if (items.empty()) {
        result_.stopReason = adaptive.reachedTarget() ? StopReason::kFinished : StopReason::kMaxSamples;
        break;
      }
      const auto takeResult = [&](std::uint64_t index, const gpu::WorkResult& result) {
        adaptive.add(items[index], result);
      };
      if (!tracer_.run(
              items.size(), [&](std::uint64_t index) { return items[index]; }, takeResult,
              [&] { return shouldStop(); })) {
        break;
      }
    }
    result_.estimatedError = adaptive.estimatedError();
    showPixels([&](std::uint64_t pixel) { return glm::vec3(adaptive.mean(pixel)); },
               [&](std::uint64_t pixel) { return adaptive.samples(pixel); },
               [&](std::uint64_t pixel) { return adaptive.estimatedError(pixel); });
  }

  // Fills the image with what the view asks for.
  template <typename Color, typename Samples, typename Error>
  void showPixels(const Color& color, const Samples& samples, const Error& error) {
    std::uint32_t most = 1;
    for (std::uint64_t pixel = 0; pixel < pixels_; ++pixel) most = std::max(most, samples(pixel));
    for (std::uint64_t pixel = 0; pixel < pixels_; ++pixel) {
      switch (settings_.view) {
        case View::kSamples:
          setPixel(pixel, glm::vec3(static_cast<float>(samples(pixel)) / static_cast<float>(most)));
          break;
        case View::kError:
          setPixel(pixel, glm::vec3(static_cast<float>(std::min(1.0, error(pixel)))));
          break;
        default:
          setPixel(pixel, color(pixel));
      }
    }
    result_.mostSamples = most;
  }

  const GpuScene& scene_;
  const Camera& camera_;
  RenderSettings settings_;
  const std::atomic<bool>& interrupted_;
  Clock::time_point start_ = Clock::now();
  int width_;
  int height_;
  std::uint64_t pixels_;
  Tracer tracer_;
  RenderResult result_;
};

}  // namespace

RenderResult render(vulkan::Device& device, const GpuScene& scene, const Camera& camera,
                    const RenderSettings& settings, const std::atomic<bool>& interrupted) {
  // The plan for a target error and the other views are about all pixels.
  if (settings.targetError || settings.view != View::kColor || !settings.specialized) {
    return Render(device, scene, camera, settings, interrupted).run();
  }
  const Rectangle& crop = settings.crop;
  RenderSettings part = settings;
  part.crop = coveredPart(scene, camera, settings);
  RenderResult result;
  if (part.crop.x0 < part.crop.x1 && part.crop.y0 < part.crop.y1) {
    result = Render(device, scene, camera, part, interrupted).run();
  }
  Image whole{crop.x1 - crop.x0, crop.y1 - crop.y0, {}};
  if (whole.width == result.image.width && whole.height == result.image.height) return result;
  whole.rgb.resize(std::size_t{3} * whole.width * whole.height);
  paste(result.image, part.crop.x0 - crop.x0, part.crop.y0 - crop.y0, whole);
  result.skippedPixels = (whole.rgb.size() - result.image.rgb.size()) / 3;
  result.image = std::move(whole);
  return result;
}

}  // namespace lavaray
