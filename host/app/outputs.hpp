#pragma once

#include <cstdio>
#include <optional>

#include "app/options.hpp"
#include "film/film.hpp"
#include "image/image_file.hpp"
#include "image/output_file.hpp"
#include "render/renderer.hpp"

namespace lavaray {

// The files that a render is to write, each replaced as a whole. Made before the rendering, so that a folder
// that cannot be written to is found out before the work; what is not written stays as it was.
class Outputs {
 public:
  // Throws Error(kOutput) where one cannot be written, Error(kUsage) where it is a file that is read.
  explicit Outputs(const Options& options);

  // Writes the picture, or the film in its place, to its file or to stdout. Throws Error(kOutput) where not
  // everything could be written.
  void writePicture(const Image& image, const TextEntries& origin);
  void writeFilm(const Render& render, const Identity& identity);
  [[nodiscard]] bool hasFilm() const { return hasFilm_; }
  // Whether the picture's file is of numbers, to compute with, rather than for the eye.
  [[nodiscard]] bool hasNumbers() const { return format_ == ImageFormat::kPfm; }

  // The statistics' stream, and after it the end of them; null where there are to be none.
  [[nodiscard]] std::FILE* json() const { return json_ ? json_->stream() : nullptr; }
  void commitJson() { json_->commit(); }

 private:
  bool hasFilm_;
  ImageFormat format_ = ImageFormat::kPpm;
  std::optional<OutputFile> output_;  // of the picture or the film; or else
  std::optional<CheckedStream> stdout_;
  std::optional<OutputFile> json_;
};

}  // namespace lavaray
