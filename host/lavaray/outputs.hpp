#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
#include <span>

#include "base/output_file.hpp"
#include "film/film.hpp"
#include "image/row_writer.hpp"
#include "lavaray/options.hpp"
#include "render/render.hpp"

namespace lavaray {

// The files that a render is to write, each replaced as a whole. Made before the render, so that a folder
// that cannot be written to is noticed before the work. A file that is not committed stays as it was.
class Outputs {
 public:
  using Clock = std::chrono::steady_clock;

  // Throws Error(kOutput) if one cannot be written, Error(kUsage) if it is a file that is read. The options
  // must outlive it.
  explicit Outputs(const Options& options);

  // Throws Error(kOutput) if a picture of that size does not fit the format.
  void checkSize(int width, int height) const;

  // The picture goes row by row, from the top, to its file or to stdout, to which nothing goes before the
  // first row. Throws Error(kOutput) as soon as something could not be written, or if the picture is too
  // large for the format.
  void beginPicture(const Rectangle& part, const TextEntries& origin);
  void writeRow(std::span<const float> rgb);
  // Writes the rows that the render has not handed over yet, as far as they are in the picture, which lies
  // within the rendered crop; stretched or coloured as the options say.
  void writeRowsOf(Render& render, const Rectangle& crop);
  void endPicture(const TextEntries& outcome);
  // The time that writing rows has taken so far.
  [[nodiscard]] Clock::duration timeOfRows() const { return timeOfRows_; }

  // Writes the film in place of a picture.
  void writeFilm(const Render& render, const Identity& identity);
  [[nodiscard]] bool hasFilm() const { return hasFilm_; }

  // The stream for the statistics, null if there are to be none; commitJson() once they are written.
  [[nodiscard]] std::FILE* json() const { return json_ ? json_->stream() : nullptr; }
  void commitJson() { json_->commit(); }

 private:
  [[nodiscard]] std::FILE* pictureStream() const;
  void claimStdout();
  void commitPicture();

  // Whether the picture's file holds numbers to compute with, rather than colours for the eye.
  [[nodiscard]] bool hasNumbers() const { return format_ == ImageFormat::kPfm; }

  const Options& options_;
  bool hasFilm_;
  ImageFormat format_ = ImageFormat::kPpm;
  std::optional<OutputFile> output_;  // the picture or the film; without it, stdout_
  std::optional<WriteClaim> stdoutClaim_;
  std::optional<CheckedStream> stdout_;
  std::optional<OutputFile> json_;
  Rectangle part_;  // the picture
  TextEntries origin_;
  std::optional<RowWriter> rows_;
  Clock::duration timeOfRows_{};
};

}  // namespace lavaray
