#include "app/outputs.hpp"

#include <fcntl.h>
#include <unistd.h>

#include "core/errors.hpp"

namespace lavaray {
namespace {

// A stream that was closed when the program began is open for reading only (program.cpp).
bool isStdoutWritable() {
  const int flags = fcntl(STDOUT_FILENO, F_GETFL);
  return flags != -1 && (flags & O_ACCMODE) != O_RDONLY;
}

}  // namespace

Outputs::Outputs(const Options& options) : hasFilm_(writesFilm(options)) {
  if (options.output != "-") {
    output_.emplace(OutputName{"--output", options.output});
  } else {
    if (!isStdoutWritable()) {
      throw Error(ExitCode::kOutput,
                  "the image cannot be written to stdout, which is closed or open for reading only");
    }
    checkNotRead(STDOUT_FILENO, "stdout");
    stdout_.emplace(STDOUT_FILENO);
  }
  if (output_ && !hasFilm_) format_ = imageFormat(options.output).value();
  if (!options.json.empty()) json_.emplace(OutputName{"--json", options.json});
}

void Outputs::writePicture(const Image& image, const TextEntries& origin) {
  writeImage(image, format_, output_ ? output_->stream() : stdout_->get(), origin);
  if (output_) return output_->commit();
  if (const std::string reason = stdout_->flush(); !reason.empty())
    throw Error(ExitCode::kOutput, "the image cannot be written to stdout: " + reason);
}

void Outputs::writeFilm(const Render& render, const Identity& identity) {
  render.writeFilm(output_->stream(), identity);
  output_->commit();
}

}  // namespace lavaray
