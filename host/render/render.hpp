#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "bvh/gpu_scene.hpp"
#include "film/film_file.hpp"
#include "image/image.hpp"
#include "render/picture_rows.hpp"
#include "render/render_statistics.hpp"
#include "render/settings.hpp"
#include "vulkan/device.hpp"

namespace lavaray {

struct RenderResult : RenderStatistics {
  Image image;  // of the crop; black where no sample was taken
};

struct SamplingProgress;
class Tracer;

// A render of settings.crop, which can be looked at and kept between two batches of work.
class Render {
 public:
  // The device and the scene must outlive it. Throws Error(kDevice) where the scene does not fit the device.
  Render(vulkan::Device& device, const GpuScene& scene, const RenderSettings& settings);
  ~Render();

  // Resumes from what the film has, as if it had been rendered here. Its identity, crop and range are those
  // of this render. Throws Error(kInput) where it cannot be read.
  void resumeFrom(FilmReader& film);

  // Called before each batch, some 10s of times a second; returns whether to go on.
  using Proceed = std::function<bool()>;
  // Where no picture is kept, each row is taken as soon as it is complete. Throws Error(kDevice) where the
  // device fails or cannot finish a ray.
  void run(const Proceed& proceed, const TakeRow& take = {});
  // Hands over the rows that run() has not: if the picture is kept all of them, each time it is called.
  void handOverRows(const TakeRow& take);

  [[nodiscard]] std::chrono::duration<double> elapsed() const;
  [[nodiscard]] double shareDone() const;  // in [0, 1]; estimated where there is a target or a time limit
  // Averaged over the pixels in which something can show; includes the samples of a film.
  [[nodiscard]] double samplesPerPixel() const;
  [[nodiscard]] double estimatedError() const;  // RMSE, where there is a target, else 0
  // The picture so far, where it is kept; black where no sample was taken.
  [[nodiscard]] Image image() const;
  [[nodiscard]] RenderStatistics statistics() const;

  // Of each pixel of the crop: the number of its samples, as if those known to be black had been sampled too,
  // and its estimated error, in units of a colour.
  [[nodiscard]] std::vector<float> pixelSamples() const;
  [[nodiscard]] std::vector<float> pixelErrors() const;

  // Writes everything that it takes to resume; the view must be the colour.
  void writeFilm(std::FILE* stream, const Identity& identity) const;

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] bool isTraced() const { return tracer_ != nullptr; }
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
  Rectangle area_;                              // of the crop, in which something can show
  std::unique_ptr<SamplingProgress> sampling_;  // these two are empty where that has no pixel
  std::unique_ptr<Tracer> tracer_;
  std::optional<PictureRows> rows_;   // where no picture is kept
  std::uint64_t earlierSamples_ = 0;  // of a film, in pixels that are sampled
  Clock::time_point start_;
  StopReason stopReason_ = StopReason::kFinished;
  bool isComplete_ = false;  // everything that was asked for is done
};

// An upper bound, or nearly so, of the bytes of the host's memory that a render with these settings takes for
// its pixels. The device's buffers come on top, and whatever the caller makes of the picture.
std::uint64_t hostBytes(const RenderSettings& settings);

// Renders everything at once.
RenderResult render(vulkan::Device& device, const GpuScene& scene, const RenderSettings& settings);

}  // namespace lavaray
