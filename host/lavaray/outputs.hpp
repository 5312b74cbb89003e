#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
#include <span>

#include "base/output_file.hpp"
#include "film/film.hpp"
#include "image/row_writer.hpp"
#include "lavaray/options.hpp"
#include "render/renderer.hpp"

namespace lavaray {

// The files that a render is to write, each replaced as a whole. Made before the rendering, so that a folder
// that cannot be written to is found out before the work; what is not written stays as it was.
class Outputs {
 public:
  using Clock = std::chrono::steady_clock;

  // Throws Error(kOutput) where one cannot be written, Error(kUsage) where it is a file that is read. The
  // options must outlive it.
  explicit Outputs(const Options& options);

  // Throws Error(kOutput) where a picture of that size does not fit the format.
  void checkSize(int width, int height) const;

  // The picture goes row by row from the top to its file or to stdout, where nothing is before the first row.
  // Throws Error(kOutput) as soon as not everything could be written, or where the picture is too large for
  // the format.
  void beginPicture(const Rectangle& part, const TextEntries& origin);
  void writeRow(std::span<const float> rgb);
  // The rows that the render has not handed over, as far as they are in the picture, which lies within the
  // crop that is rendered: stretched or coloured as the options say.
  void writeRowsOf(Render& render, const Rectangle& crop);
  void endPicture(const TextEntries& outcome);
  // What writing the rows has taken so far.
  [[nodiscard]] Clock::duration timeOfRows() const { return timeOfRows_; }

  // The film in its place.
  void writeFilm(const Render& render, const Identity& identity);
  [[nodiscard]] bool hasFilm() const { return hasFilm_; }

  // The statistics' stream, and after it the end of them; null where there are to be none.
  [[nodiscard]] std::FILE* json() const { return json_ ? json_->stream() : nullptr; }
  void commitJson() { json_->commit(); }

 private:
  [[nodiscard]] std::FILE* pictureStream() const;
  void claimStdout();
  void commitPicture();

  // Whether the picture's file is of numbers, to compute with, rather than for the eye.
  [[nodiscard]] bool hasNumbers() const { return format_ == ImageFormat::kPfm; }

  const Options& options_;
  bool hasFilm_;
  ImageFormat format_ = ImageFormat::kPpm;
  std::optional<OutputFile> output_;  // of the picture or the film; or else
  std::optional<WriteClaim> stdoutClaim_;
  std::optional<CheckedStream> stdout_;
  std::optional<OutputFile> json_;
  Rectangle part_;  // the picture
  TextEntries origin_;
  std::optional<RowWriter> rows_;
  Clock::duration timeOfRows_{};
};

}  // namespace lavaray
