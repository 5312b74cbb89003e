#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <span>

#include "bvh/gpu_scene.hpp"
#include "film/film_file.hpp"
#include "image/image.hpp"
#include "render/picture_rows.hpp"
#include "render/render_statistics.hpp"
#include "render/sampling_progress.hpp"
#include "render/settings.hpp"
#include "render/tracer.hpp"

namespace lavaray {

struct RenderResult : RenderStatistics {
  Image image;  // of the crop's size; black where no sample was taken
};

// A render of settings.crop. Between two batches of work it can be looked at and kept.
class Render {
 public:
  // The device and the scene must outlive it. Throws Error(kDevice) where the scene does not fit the device.
  Render(vulkan::Device& device, const GpuScene& scene, const RenderSettings& settings);

  // Resumes from what the film has, as if it had been rendered here. Its identity, crop and range are those
  // of this render. Throws Error(kInput) where it cannot be read.
  void resumeFrom(FilmReader& film);

  // Is called about ten times a second and returns whether to go on.
  using Proceed = std::function<bool()>;
  // Where no picture is kept, each row is taken as soon as it is complete. Throws Error(kDevice) where the
  // device fails or cannot finish a ray.
  void run(const Proceed& proceed, const TakeRow& take = {});
  // Hands over the rows that run has not: all of them where the picture is kept, as often as it is called.
  void handOverRows(const TakeRow& take);

  [[nodiscard]] std::chrono::duration<double> elapsed() const;
  [[nodiscard]] double shareDone() const;  // in [0, 1]; estimated where there is a target or a time limit
  // In the mean over the pixels in which something can show, those of a film included.
  [[nodiscard]] double samplesPerPixel() const;
  [[nodiscard]] double estimatedError() const;  // RMSE, where there is a target, else 0
  // As far as it is known, where the picture is kept; black where no sample was taken.
  [[nodiscard]] Image image() const;
  [[nodiscard]] RenderStatistics statistics() const;

  // Of each pixel of the crop: its samples, those that are known to be black without one among them, and its
  // estimated error, in units of a colour.
  [[nodiscard]] std::vector<float> pixelSamples() const;
  [[nodiscard]] std::vector<float> pixelErrors() const;

  // Writes all there is, to go on from; the view is the colour.
  void writeFilm(std::FILE* stream, const Identity& identity) const;

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] bool isTraced() const { return tracer_.has_value(); }
  [[nodiscard]] std::optional<StopReason> reasonToStop(const Proceed& proceed) const;
  [[nodiscard]] std::uint64_t sampledPixels() const;
  void forEachRow(const TakeRow& take) const;
  void copyShown(std::uint64_t first, std::span<glm::vec3> values) const;
  [[nodiscard]] float measureOf(std::uint64_t pixel) const;
  [[nodiscard]] float largestMeasure() const;
  template <typename Value>
  [[nodiscard]] std::vector<float> valuesOfCrop(float elsewhere, const Value& value) const;

  const vulkan::Device& device_;
  RenderSettings settings_;
  Rectangle area_;                            // of the crop, in which something can show
  std::optional<SamplingProgress> sampling_;  // these two are empty where that has no pixel
  std::optional<Tracer> tracer_;
  std::optional<PictureRows> rows_;   // where no picture is kept
  std::uint64_t earlierSamples_ = 0;  // of a film, in pixels that are sampled
  Clock::time_point start_;
  StopReason stopReason_ = StopReason::kFinished;
  bool isComplete_ = false;  // all is done that was asked for
};

// An upper bound, or nearly so, of the bytes of the host's memory that a render with these settings takes for
// its pixels. The device's buffers come on top, and whatever the caller makes of the picture.
std::uint64_t hostBytes(const RenderSettings& settings);

// Renders all at once.
RenderResult render(vulkan::Device& device, const GpuScene& scene, const RenderSettings& settings);

}  // namespace lavaray
