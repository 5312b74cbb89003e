#pragma once

#include <lavaray/renderer.h>

#include <chrono>
#include <cstdio>
#include <optional>

#include "lavaray/options.hpp"

namespace lavaray {

// The files that a render is to write, each replaced as a whole. Made before the render, so that a folder
// that cannot be written to is noticed before the work. A file that is not committed stays as it was.
class Outputs {
 public:
  using Clock = std::chrono::steady_clock;

  // Throws Error(kOutput) if one cannot be written, Error(kUsage) if it is a file that is read.
  explicit Outputs(const Options& options);

  // Throws Error(kOutput) if a picture of that size does not fit the format.
  void checkSize(const ImageSize& size) const;

  // The picture goes row by row, from the top, to its file or to stdout, to which nothing goes before the
  // first row. Throws Error(kOutput) as soon as something could not be written, or if the picture is too
  // large for the format.
  void beginPicture(const ImageSize& size, const TextEntries& origin);
  void writeRow(const float* rgb);
  void endPicture(const TextEntries& outcome);
  // The time that writing rows has taken so far.
  [[nodiscard]] Clock::duration timeOfRows() const { return timeOfRows_; }

  // Writes the film in place of a picture.
  void writeFilm(RenderJob& job);
  [[nodiscard]] bool hasFilm() const { return hasFilm_; }

  // The stream for the statistics, null if there are to be none; commitJson() once they are written.
  [[nodiscard]] std::FILE* json() const { return json_ ? json_->stream() : nullptr; }
  void commitJson() { json_->commit(); }

 private:
  bool hasFilm_;
  ImageFormat format_ = ImageFormat::kPpm;
  std::optional<OutputFile> output_;  // the picture or the film
  std::optional<OutputFile> json_;
  ImageSize size_;  // of the picture
  TextEntries origin_;
  std::optional<ImageWriter> rows_;
  Clock::duration timeOfRows_{};
};

}  // namespace lavaray
