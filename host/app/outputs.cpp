#include "app/outputs.hpp"

#include "core/errors.hpp"

namespace lavaray {

Outputs::Outputs(const Options& options) : hasFilm_(writesFilm(options)) {
  if (options.output != "-") output_.emplace(options.output);
  if (output_ && !hasFilm_) format_ = imageFormat(options.output).value();
  if (!options.json.empty()) json_.emplace(options.json);
}

void Outputs::writePicture(const Image& image, const TextEntries& origin) {
  writeImage(image, format_, output_ ? output_->stream() : stdout, origin);
  if (output_) return output_->commit();
  // A write that failed earlier is remembered by the stream alone.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw Error(ExitCode::kOutput,
                "the image cannot be written to stdout: is there room, and does anyone read?");
  }
}

void Outputs::writeFilm(const Render& render, const Identity& identity) {
  render.writeFilm(output_->stream(), identity);
  output_->commit();
}

}  // namespace lavaray
