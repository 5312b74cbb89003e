#include "render/render.hpp"

#include <algorithm>

#include "render/coverage.hpp"
#include "render/sampling_progress.hpp"
#include "render/tracer.hpp"

namespace lavaray {
namespace {

// The area of the crop to trace. Everything else is black, though a user's shader may see it differently. The
// plan for a target error and the other views need all pixels.
Rectangle tracedArea(const GpuScene& scene, const RenderSettings& settings) {
  const bool isAboutAll = settings.targetError || settings.view != View::kColor || !settings.shader.empty();
  return isAboutAll || !settings.specialized ? settings.crop : coverage(scene, settings);
}

}  // namespace

Render::Render(vulkan::Device& device, const GpuScene& scene, const RenderSettings& settings)
    : device_(device), settings_(settings), area_(tracedArea(scene, settings)), start_(Clock::now()) {
  if (!settings.keepsPicture) rows_.emplace(settings.crop, area_);
  if (area_.pixels() == 0) return;
  sampling_ = std::make_unique<SamplingProgress>(beginSampling(scene, settings, area_));
  tracer_ = std::make_unique<Tracer>(device, scene, settings, area_, maxItems(settings, area_.pixels()));
}

Render::~Render() = default;

void Render::resumeFrom(FilmReader& film) {
  if (!isTraced()) return;
  lavaray::resumeFrom(film, *sampling_);
  for (std::uint64_t pixel = 0; pixel < area_.pixels(); ++pixel) {
    if (!tracer_->skips(pixel)) earlierSamples_ += sampling_->sums.samples(pixel);
  }
}

void Render::run(const Proceed& proceed, const TakeRow& take) {
  isComplete_ = !isTraced();
  std::optional<StopReason> reason;
  while (isTraced()) {
    while (!reason && tracer_->canBegin() && hasItems(*sampling_)) {
      reason = reasonToStop(proceed);
      if (!reason) sampling_->itemsGiven += tracer_->begin(sampling_->passes.back(), sampling_->itemsGiven);
    }
    if (tracer_->isIdle()) break;
    tracer_->take([&](std::uint64_t /*first*/, std::span<const gpu::WorkResult> results) {
      add(*sampling_, results);
      if (!rows_) return;
      for (const gpu::WorkResult& result : results) rows_->add(result.sum, take);
    });
  }
  stopReason_ = reason.value_or(StopReason::kFinished);
  if (!isTraced() || reason) return;
  isComplete_ = true;
  if (sampling_->plan && !sampling_->plan->reachedTarget()) stopReason_ = StopReason::kMaxSamples;
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
  return std::clamp(timeShare, lavaray::shareDone(*sampling_), 1.0);
}

// Pixels known to be black have no samples, or only some that the plan counts but nobody traces.
std::uint64_t Render::sampledPixels() const {
  return isTraced() ? area_.pixels() - tracer_->skippedPixels() : 0;
}

double Render::samplesPerPixel() const {
  if (sampledPixels() == 0) return 0.0;
  return static_cast<double>(earlierSamples_ + tracer_->counts().samples) /
         static_cast<double>(sampledPixels());
}

double Render::estimatedError() const {
  return isTraced() ? lavaray::estimatedError(*sampling_) : 0.0;
}

void Render::handOverRows(const TakeRow& take) {
  if (rows_) {
    rows_->finish(take);
  } else {
    forEachRow(take);
  }
}

Image Render::image() const {
  Image result{settings_.crop.width(), settings_.crop.height(), {}};
  result.rgb.reserve(3 * settings_.crop.pixels());
  forEachRow(
      [&](std::span<const float> row) { result.rgb.insert(result.rgb.end(), row.begin(), row.end()); });
  return result;
}

void Render::forEachRow(const TakeRow& take) const {
  PictureRows rows(settings_.crop, area_);
  if (isTraced()) {
    std::vector<glm::vec3> values(static_cast<std::size_t>(area_.width()));
    const float largest = settings_.view == View::kSamples ? static_cast<float>(sampling_->sums.maxSamples())
                                                           : largestMeasure();
    const float white = largest > 0.0F ? largest : 1.0F;  // the value that is shown as 1
    for (std::uint64_t first = 0; first < area_.pixels(); first += values.size()) {
      copyShown(first, values);
      for (const glm::vec3& value : values) rows.add(value / white, take);
    }
  }
  rows.finish(take);
}

// One value for each pixel of the crop; `value` gives those of the area by pixel number.
template <typename Value>
std::vector<float> Render::valuesOfCrop(float elsewhere, const Value& value) const {
  const Rectangle& crop = settings_.crop;
  std::vector<float> values(crop.pixels(), elsewhere);
  std::uint64_t pixel = 0;
  for (int y = area_.y0; isTraced() && y < area_.y1; ++y) {
    const std::size_t row = static_cast<std::size_t>(y - crop.y0) * crop.width();
    for (int x = area_.x0; x < area_.x1; ++x) values[row + (x - crop.x0)] = value(pixel++);
  }
  return values;
}

std::vector<float> Render::pixelSamples() const {
  const SampleRange range = sampleRange(settings_);
  return valuesOfCrop(static_cast<float>(range.end - range.first), [this](std::uint64_t pixel) {
    return static_cast<float>(sampling_->sums.samples(pixel));
  });
}

std::vector<float> Render::pixelErrors() const {
  return valuesOfCrop(0.0F, [this](std::uint64_t pixel) {
    return sampling_->plan ? static_cast<float>(sampling_->plan->estimatedError(pixel)) : 0.0F;
  });
}

RenderStatistics Render::statistics() const {
  RenderStatistics result;
  result.stopReason = stopReason_;
  result.skippedPixels = settings_.crop.pixels() - sampledPixels();
  result.samplesPerPixel = samplesPerPixel();
  if (!isTraced()) return result;
  result.maxSamples = std::max(sampling_->sums.maxSamples(), 1U);
  result.estimatedError = estimatedError();
  result.counts = tracer_->counts();
  result.activity = tracer_->activity();
  result.deviceBytes = tracer_->deviceBytes();
  result.tuning = tracer_->tuning();
  result.largestMeasure = double{largestMeasure()};
  return result;
}

void Render::writeFilm(std::FILE* stream, const Identity& identity) const {
  if (isTraced()) listRest(*sampling_);
  FilmHeader header;
  header.identity = identity;
  header.device = device_.description().name;
  header.size = settings_.size;
  header.crop = settings_.crop;
  header.traced = area_;
  if (!settings_.targetError) {
    header.range = sampleRange(settings_);
    header.samples = settings_.samples;
  }
  header.isComplete = isComplete_;
  if (isTraced()) describe(*sampling_, header);
  FilmWriter film(stream, header);
  if (isTraced()) write(*sampling_, film);
  film.finish();
}

// What the view shows of the pixels from number `first` on; measures and numbers of samples are not yet
// scaled.
void Render::copyShown(std::uint64_t first, std::span<glm::vec3> values) const {
  if (settings_.view == View::kSamples) {
    for (glm::vec3& value : values) value = glm::vec3(static_cast<float>(sampling_->sums.samples(first++)));
  } else if (settings_.view == View::kError) {
    for (glm::vec3& value : values) {
      value = glm::vec3(static_cast<float>(std::min(1.0, sampling_->plan->estimatedError(first++))));
    }
  } else if (isMeasure(settings_.view)) {
    for (glm::vec3& value : values) value = glm::vec3(measureOf(first++));
  } else {
    sampling_->sums.copyMeans(first, values);
  }
}

float Render::measureOf(std::uint64_t pixel) const {
  const SampleSums& sums = sampling_->sums;
  return static_cast<float>(measure(settings_.view, sums.sum(pixel), sums.samples(pixel)));
}

// 0 if the view is not a measure.
float Render::largestMeasure() const {
  float largest = 0.0F;
  for (std::uint64_t pixel = 0; isMeasure(settings_.view) && pixel < area_.pixels(); ++pixel)
    largest = std::max(largest, measureOf(pixel));
  return largest;
}

std::uint64_t hostBytes(const RenderSettings& settings) {
  return samplingBytes(settings, settings.crop.pixels());
}

RenderResult render(vulkan::Device& device, const GpuScene& scene, const RenderSettings& settings) {
  Render render(device, scene, settings);
  render.run([] { return true; });
  return {render.statistics(), render.image()};
}

}  // namespace lavaray
