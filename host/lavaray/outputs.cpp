#include "lavaray/outputs.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace lavaray {
namespace {

// A stream that was closed when the program started is open for reading only (program.cpp).
bool isStdoutWritable() {
  const int flags = fcntl(STDOUT_FILENO, F_GETFL);
  return flags != -1 && (flags & O_ACCMODE) != O_RDONLY;
}

}  // namespace

Outputs::Outputs(const Options& options) : hasFilm_(writesFilm(options)) {
  const OutputName picture{"--output", options.output};
  if (options.output != "-") {
    output_.emplace(picture);
  } else {
    if (!isStdoutWritable()) {
      throw Error(ErrorKind::kOutput,
                  "the image cannot be written to stdout, which is closed or open for reading only");
    }
    output_.emplace(STDOUT_FILENO, picture);
  }
  if (options.output != "-" && !hasFilm_)
    format_ = options.half ? ImageFormat::kExrHalf : imageFormat(options.output).value();
  if (!options.json.empty()) json_.emplace(OutputName{"--json", options.json});
}

void Outputs::checkSize(const ImageSize& size) const {
  if (!hasFilm_) lavaray::checkSize(format_, size);
}

void Outputs::beginPicture(const ImageSize& size, const TextEntries& origin) {
  size_ = size;
  origin_ = origin;
}

void Outputs::writeRow(const float* rgb) {
  const Clock::time_point start = Clock::now();
  if (!rows_) rows_.emplace(*output_, format_, size_, origin_);
  rows_->write(rgb);
  timeOfRows_ += Clock::now() - start;
}

void Outputs::endPicture(const TextEntries& outcome) {
  rows_->finish(outcome);
  output_->commit();
}

void Outputs::writeFilm(RenderJob& job) {
  job.writeFilm(*output_);
  output_->commit();
}

}  // namespace lavaray
