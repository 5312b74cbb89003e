#include "library/render_options.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/errors.hpp"
#include "base/limits.hpp"
#include "base/number_text.hpp"
#include "interface.h"
#include "library/guarded.hpp"
#include "library/scene_state.hpp"
#include "render/view.hpp"
#include "scene/camera.hpp"

namespace lavaray {
namespace {

static_assert(v0::kMaxImageSide == kMaxImageSide && v0::kMaxSamplesPerPixel == kMaxSamplesPerPixel &&
              v0::kMaxMagnitude == kMaxMagnitude);

constexpr double kMaxSeconds = 1e9;

void checkRange(const char* option, double value, double min, double max) {
  if (value >= min && value <= max) return;
  throw Error(ExitCode::kUsage, std::string(option) + " is " + numberText(value) + ", allowed is " +
                                    numberText(min) + " to " + numberText(max));
}

void checkSampleRange(const v0::SamplingOptions& options) {
  if (!options.range) return;
  const auto [first, end] = *options.range;
  const auto fits = [&](std::uint32_t i) { return i % gpu::kMaxSamplesPerItem == 0 || i == options.samples; };
  // Samples are summed in groups of so many. A part must not split one, or the sum would be rounded
  // differently.
  if (options.samples > 1 && first < end && end <= options.samples && fits(first) && fits(end)) return;
  throw Error(ExitCode::kUsage,
              "--sample-range A:B must have 0 <= A < B <= " + std::to_string(options.samples) +
                  ", the samples of --spp, of which 2 or more must be asked for; A and B multiples of " +
                  std::to_string(gpu::kMaxSamplesPerItem) + ", or B all samples");
}

void checkViewAndError(const v0::SamplingOptions& options) {
  if (options.view == View::kError && !options.targetError) {
    throw Error(ExitCode::kUsage, "--view error needs --target-error: without, the error is not estimated");
  }
  if (options.targetError && tracedView(options.view) != gpu::kViewColor) {
    throw Error(ExitCode::kUsage, "--target-error is for the views color, samples and error; for view " +
                                      viewName(options.view) + " give --spp");
  }
}

void checkSides(const v0::RenderOptions& options) {
  checkRange("--width", options.width, 0.0, kMaxImageSide);
  checkRange("--height", options.height, 0.0, kMaxImageSide);
}

void checkRanges(const v0::RenderOptions& options) {
  checkSides(options);
  checkRange("--max-depth", options.maxDepth, 0.0, v0::kMaxMirrorBounces);
  checkRange("--spp", options.samples, 1.0, kMaxSamplesPerPixel);
  checkRange("--max-spp", options.maxSamples, 2.0, kMaxSamplesPerPixel);
  if (options.targetError) checkRange("--target-error", *options.targetError, 1e-6, 1.0);
  if (options.timeLimitSeconds) checkRange("--time-limit", *options.timeLimitSeconds, 0.0, kMaxSeconds);
}

void checkFilm(const v0::RenderOptions& options) {
  if (!options.keepsFilm || options.view == View::kColor) return;
  throw Error(ExitCode::kUsage, "a checkpoint or film is of colours; --view " + viewName(options.view) +
                                    " cannot be kept in one");
}

// At one sample per pixel, rows can be taken while others are traced, unless something needs all of them.
bool keepsPicture(const v0::RenderOptions& options) {
  return !takesCenters(options) || needsWhole(options) || options.view == View::kSamples ||
         options.keepsPicture || options.keepsFilm;
}

}  // namespace

ImageSize outputSize(const v0::RenderOptions& options, const ImageSize& cameraSize) {
  checkSides(options);
  const double aspect = static_cast<double>(cameraSize.width) / cameraSize.height;
  ImageSize size = cameraSize;
  if (options.width != 0) size.width = options.width;
  if (options.height != 0) size.height = options.height;
  const auto rounded = [](double pixels) { return std::max(1, static_cast<int>(std::lround(pixels))); };
  if (options.width != 0 && options.height == 0) size.height = rounded(size.width / aspect);
  if (options.height != 0 && options.width == 0) size.width = rounded(size.height * aspect);
  if (size.width > kMaxImageSide || size.height > kMaxImageSide) {
    throw Error(ExitCode::kUsage, "an image of " + std::to_string(size.width) + " x " +
                                      std::to_string(size.height) + " pixels; each side may have 1 to " +
                                      std::to_string(kMaxImageSide));
  }
  return size;
}

bool needsWhole(const v0::RenderOptions& options) {
  return options.normalize || isMeasure(options.view);
}

RenderPlan planFor(const v0::RenderOptions& options, const Scene& scene) {
  v0::checkOptions(options);
  RenderPlan plan;
  RenderSettings& settings = plan.settings;
  static_cast<v0::SamplingOptions&>(settings) = static_cast<const v0::SamplingOptions&>(options);
  settings.size = outputSize(options, imageSize(scene.camera).value());
  const Rectangle whole{0, 0, settings.size.width, settings.size.height};
  plan.part = v0::cropWithin(options.crop, settings.size);
  settings.crop = needsWhole(options) ? whole : plan.part;
  settings.keepsPicture = keepsPicture(options);
  settings.countRays = options.countRays;
  settings.recordTimes = options.countRays;
  if (options.shader) settings.shader = options.shader->spirv;
  return plan;
}

namespace v0 {

void checkOptions(const RenderOptions& options) {
  guarded([&] {
    checkRanges(options);
    checkViewAndError(options);
    checkSampleRange(options);
    checkFilm(options);
  });
}

ImageSize pictureSize(const Scene& scene, const RenderOptions& options) {
  return guarded([&] { return outputSize(options, imageSize(scene.state().scene.camera).value()); });
}

}  // namespace v0
}  // namespace lavaray
