#include "render/renderer.hpp"

#include <algorithm>

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
  if (settings.samples == 1)
    return std::make_unique<CenterSampling>(pixelsOf(part), settings.view, settings.keepsPicture);
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
  if (!settings_.keepsPicture) rows_.emplace(crop_, settings_.crop);
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

void Render::run(const Proceed& proceed, const TakeRow& take) {
  stopReason_ = StopReason::kFinished;
  isComplete_ = !isTraced();
  if (!isTraced()) return;
  while (sampling_->itemsDone() < sampling_->passItems() || sampling_->startPass()) {
    const bool finished = tracer_->run(
        sampling_->itemsDone(), sampling_->passItems(),
        [this](std::uint64_t first, std::span<gpu::WorkItem> items) { sampling_->makeItems(first, items); },
        [&](std::uint64_t /*first*/, std::span<const gpu::WorkResult> results) {
          sampling_->add(results);
          if (!rows_) return;
          for (const gpu::WorkResult& result : results) rows_->add(result.sum, take);
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

void Render::handOverRows(const TakeRow& take) {
  if (rows_) {
    rows_->finish(take);
  } else {
    forEachRow(take);
  }
}

Image Render::image() const {
  Image result{crop_.x1 - crop_.x0, crop_.y1 - crop_.y0, {}};
  result.rgb.reserve(3 * pixelsOf(crop_));
  forEachRow(
      [&](std::span<const float> row) { result.rgb.insert(result.rgb.end(), row.begin(), row.end()); });
  return result;
}

void Render::forEachRow(const TakeRow& take) const {
  const Rectangle& part = settings_.crop;
  PictureRows rows(crop_, part);
  if (isTraced()) {
    std::vector<glm::vec3> values(static_cast<std::size_t>(part.x1 - part.x0));
    const float largest =
        settings_.view == View::kSamples ? static_cast<float>(sampling_->mostSamples()) : largestMeasure();
    const float white = largest > 0.0F ? largest : 1.0F;  // The value that is shown as 1.
    for (std::uint64_t first = 0; first < pixelsOf(part); first += values.size()) {
      copyShown(first, values);
      for (const glm::vec3& value : values) rows.add(value / white, take);
    }
  }
  rows.finish(take);
}

// One value for each pixel of the crop: of the traced ones by their number.
template <typename Value>
std::vector<float> Render::wholeValues(float elsewhere, const Value& value) const {
  std::vector<float> values(pixelsOf(crop_), elsewhere);
  const Rectangle& part = settings_.crop;
  std::uint64_t pixel = 0;
  for (int y = part.y0; isTraced() && y < part.y1; ++y) {
    const std::size_t row = static_cast<std::size_t>(y - crop_.y0) * (crop_.x1 - crop_.x0);
    for (int x = part.x0; x < part.x1; ++x) values[row + (x - crop_.x0)] = value(pixel++);
  }
  return values;
}

std::vector<float> Render::pixelSamples() const {
  const SampleRange range = sampleRange(settings_);
  return wholeValues(static_cast<float>(range.end - range.first),
                     [this](std::uint64_t pixel) { return static_cast<float>(sampling_->samples(pixel)); });
}

std::vector<float> Render::pixelErrors() const {
  return wholeValues(
      0.0F, [this](std::uint64_t pixel) { return static_cast<float>(sampling_->estimatedError(pixel)); });
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
  result.largestMeasure = double{largestMeasure()};
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

// What the view shows of the pixels from number `first` on, measures and numbers of samples as they are.
void Render::copyShown(std::uint64_t first, std::span<glm::vec3> values) const {
  if (settings_.view == View::kSamples) {
    for (glm::vec3& value : values) value = glm::vec3(static_cast<float>(sampling_->samples(first++)));
  } else if (settings_.view == View::kError) {
    for (glm::vec3& value : values) {
      value = glm::vec3(static_cast<float>(std::min(1.0, sampling_->estimatedError(first++))));
    }
  } else {
    sampling_->copyValues(first, values);
  }
}

// 0 where the view is none.
float Render::largestMeasure() const {
  if (!isMeasure(settings_.view)) return 0.0F;
  float largest = 0.0F;
  std::vector<glm::vec3> values(static_cast<std::size_t>(settings_.crop.x1 - settings_.crop.x0));
  for (std::uint64_t first = 0; first < sampling_->pixels(); first += values.size()) {
    sampling_->copyValues(first, values);
    for (const glm::vec3& value : values) largest = std::max(largest, value.x);
  }
  return largest;
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
  return {render.statistics(), render.image()};
}

}  // namespace lavaray
