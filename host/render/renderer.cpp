#include "render/renderer.hpp"

#include <algorithm>
#include <utility>

#include "render/center_sampling.hpp"
#include "render/covered_part.hpp"
#include "render/fixed_sampling.hpp"
#include "render/small_objects.hpp"
#include "render/target_sampling.hpp"

namespace lavaray {
namespace {

std::uint64_t pixelsOf(const Rectangle& part) {
  return static_cast<std::uint64_t>(part.x1 - part.x0) * static_cast<std::uint64_t>(part.y1 - part.y0);
}

// The part of the crop to trace; all else is black, unless a shader of the user's knows better. The plan for
// a target error and the other views are about all pixels.
Rectangle tracedPart(const GpuScene& scene, const Camera& camera, const RenderSettings& settings) {
  const bool isAboutAll = settings.targetError || settings.view != View::kColor || !settings.shader.empty();
  if (isAboutAll || !settings.specialized) return settings.crop;
  return coveredPart(scene, camera, settings);
}

SampleRange sampleRange(const RenderSettings& settings) {
  return settings.range.value_or(SampleRange{0, settings.samples});
}

std::unique_ptr<Sampling> makeSampling(const GpuScene& scene, const Camera& camera,
                                       const RenderSettings& settings) {
  const Rectangle& part = settings.crop;
  if (settings.targetError) {
    return std::make_unique<TargetSampling>(
        AdaptiveSampling(part.x1 - part.x0, part.y1 - part.y0, *settings.targetError, settings.maxSamples,
                         settings.sampler == Sampler::kSobol, pixelsOfSmallObjects(scene, camera, settings)));
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

}  // namespace

const char* stopReasonName(StopReason reason) {
  switch (reason) {
    case StopReason::kMaxSamples:
      return "maxSamples";
    case StopReason::kTimeLimit:
      return "timeLimit";
    case StopReason::kInterrupted:
      return "interrupted";
    case StopReason::kFinished:
      break;
  }
  return "finished";
}

Render::Render(vulkan::Device& device, const GpuScene& scene, const Camera& camera,
               const RenderSettings& settings)
    : device_(device), crop_(settings.crop), settings_(settings), start_(Clock::now()) {
  settings_.crop = tracedPart(scene, camera, settings);
  if (pixelsOf(settings_.crop) == 0) return;
  sampling_ = makeSampling(scene, camera, settings_);
  tracer_.emplace(device, scene, camera, settings_, mostItems(settings_));
}

Render::~Render() = default;

void Render::goOnFrom(FilmReader& film) {
  if (!isTraced()) return;
  sampling_->read(film);
  for (std::uint64_t pixel = 0; pixel < pixelsOf(settings_.crop); ++pixel) {
    if (!tracer_->skips(pixel)) earlierSamples_ += sampling_->samples(pixel);
  }
}

void Render::run(const Proceed& proceed) {
  stopReason_ = StopReason::kFinished;
  isComplete_ = !isTraced();
  if (!isTraced()) return;
  while (sampling_->itemsDone() < sampling_->passItems() || sampling_->startPass()) {
    const bool finished = tracer_->run(
        sampling_->itemsDone(), sampling_->passItems(),
        [this](std::uint64_t first, std::span<gpu::WorkItem> items) { sampling_->makeItems(first, items); },
        [this](std::uint64_t /*first*/, std::span<const gpu::WorkResult> results) {
          sampling_->add(results);
        },
        [&] {
          const std::optional<StopReason> reason = reasonToStop(proceed);
          if (reason) stopReason_ = *reason;
          return reason.has_value();
        });
    if (!finished) return;
  }
  isComplete_ = true;
  if (!sampling_->reachedGoal()) stopReason_ = StopReason::kMaxSamples;
}

std::optional<StopReason> Render::reasonToStop(const Proceed& proceed) const {
  if (!proceed()) return StopReason::kInterrupted;
  if (settings_.timeLimitSeconds && elapsed().count() >= *settings_.timeLimitSeconds)
    return StopReason::kTimeLimit;
  return std::nullopt;
}

std::chrono::duration<double> Render::elapsed() const {
  return Clock::now() - start_;
}

double Render::shareDone() const {
  if (!isTraced()) return 1.0;
  const double timeShare = settings_.timeLimitSeconds ? elapsed().count() / *settings_.timeLimitSeconds : 0.0;
  return std::clamp(timeShare, sampling_->shareDone(), 1.0);
}

// Those that are known to be black have no samples, or only such as the plan counts and nobody traces.
std::uint64_t Render::sampledPixels() const {
  return isTraced() ? pixelsOf(settings_.crop) - tracer_->skippedPixels() : 0;
}

double Render::samplesPerPixel() const {
  if (sampledPixels() == 0) return 0.0;
  return static_cast<double>(earlierSamples_ + tracer_->counts().samples) /
         static_cast<double>(sampledPixels());
}

double Render::estimatedError() const {
  return isTraced() ? sampling_->estimatedError() : 0.0;
}

Image Render::image() const {
  const std::uint64_t pixels = pixelsOf(settings_.crop);
  std::vector<float> values(3 * pixels);
  if (isTraced()) copyShown({reinterpret_cast<glm::vec3*>(values.data()), pixels});
  Image whole = wholeImage(std::move(values));
  if (isMeasure(settings_.view)) normalize(whole);
  return whole;
}

Image Render::takeImage() {
  const bool showsOther = settings_.view == View::kSamples || settings_.view == View::kError;
  if (!isTraced() || showsOther) return image();
  Image whole = wholeImage(sampling_->takeValues());
  if (isMeasure(settings_.view)) largestMeasure_ = double{normalize(whole)};
  return whole;
}

// The picture that is asked for, of the values of its traced part.
Image Render::wholeImage(std::vector<float> values) const {
  const Rectangle& part = settings_.crop;
  Image traced{part.x1 - part.x0, part.y1 - part.y0, std::move(values)};
  Image whole{crop_.x1 - crop_.x0, crop_.y1 - crop_.y0, {}};
  if (whole.width == traced.width && whole.height == traced.height) return traced;
  whole.rgb.resize(3 * pixelsOf(crop_));
  paste(traced, part.x0 - crop_.x0, part.y0 - crop_.y0, whole);
  return whole;
}

RenderStatistics Render::statistics() const {
  RenderStatistics result;
  result.stopReason = stopReason_;
  result.skippedPixels = pixelsOf(crop_) - sampledPixels();
  result.samplesPerPixel = samplesPerPixel();
  if (!isTraced()) return result;
  result.mostSamples = std::max(sampling_->mostSamples(), 1U);
  result.estimatedError = sampling_->estimatedError();
  result.counts = tracer_->counts();
  result.deviceBytes = tracer_->deviceBytes();
  result.largestMeasure = largestMeasure_;
  return result;
}

void Render::writeFilm(std::FILE* stream, const Identity& identity) const {
  FilmHeader header;
  header.identity = identity;
  header.device = device_.description().name;
  header.size = settings_.size;
  header.crop = crop_;
  header.traced = settings_.crop;
  if (!settings_.targetError) {
    header.range = sampleRange(settings_);
    header.samples = settings_.samples;
  }
  header.isComplete = isComplete_;
  if (isTraced()) sampling_->describe(header);
  FilmWriter film(stream, header);
  if (isTraced()) sampling_->write(film);
  film.finish();
}

// What the view shows of each pixel.
void Render::copyShown(std::span<glm::vec3> values) const {
  if (settings_.view == View::kSamples) {
    const auto most = static_cast<float>(std::max(sampling_->mostSamples(), 1U));
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel) {
      values[pixel] = glm::vec3(static_cast<float>(sampling_->samples(pixel)) / most);
    }
  } else if (settings_.view == View::kError) {
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel) {
      values[pixel] = glm::vec3(static_cast<float>(std::min(1.0, sampling_->estimatedError(pixel))));
    }
  } else {
    sampling_->copyValues(values);
  }
}

std::uint64_t hostBytes(const RenderSettings& settings) {
  const std::uint64_t pixels = pixelsOf(settings.crop);
  if (settings.targetError) return pixels * AdaptiveSampling::bytesPerPixel();
  if (settings.samples > 1) return pixels * FixedSampling::bytesPerPixel(settings.view);
  return settings.keepsPicture ? pixels * sizeof(glm::vec3) : 0;
}

RenderResult render(vulkan::Device& device, const GpuScene& scene, const Camera& camera,
                    const RenderSettings& settings) {
  Render render(device, scene, camera, settings);
  render.run([] { return true; });
  Image image = render.takeImage();
  return {render.statistics(), std::move(image)};
}

}  // namespace lavaray
