#include "lavaray/outputs.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <vector>

#include "base/errors.hpp"
#include "image/false_color.hpp"

namespace lavaray {
namespace {

// A stream that was closed when the program started is open for reading only (program.cpp).
bool isStdoutWritable() {
  const int flags = fcntl(STDOUT_FILENO, F_GETFL);
  return flags != -1 && (flags & O_ACCMODE) != O_RDONLY;
}

}  // namespace

Outputs::Outputs(const Options& options) : options_(options), hasFilm_(writesFilm(options)) {
  if (options.output != "-") {
    output_.emplace(OutputName{"--output", options.output});
  } else {
    if (!isStdoutWritable()) {
      throw Error(ExitCode::kOutput,
                  "the image cannot be written to stdout, which is closed or open for reading only");
    }
    checkNotRead(STDOUT_FILENO, "stdout");
    claimStdout();
    stdout_.emplace(STDOUT_FILENO);
  }
  if (output_ && !hasFilm_)
    format_ = options.half ? ImageFormat::kExrHalf : imageFormat(options.output).value();
  if (!options.json.empty()) json_.emplace(OutputName{"--json", options.json});
}

// Keeps other outputs from being the file that stdout goes to.
void Outputs::claimStdout() {
  struct stat status {};
  if (fstat(STDOUT_FILENO, &status) != 0 || !S_ISREG(status.st_mode)) return;
  stdoutClaim_.emplace(WriteTarget("/proc/self/fd/" + std::to_string(STDOUT_FILENO)), "-", "--output",
                       std::filesystem::path());
}

void Outputs::checkSize(int width, int height) const {
  if (output_ && !hasFilm_ && format_ == ImageFormat::kBmp) checkBmpSize(width, height);
}

std::FILE* Outputs::pictureStream() const {
  return output_ ? output_->stream() : stdout_->get();
}

void Outputs::beginPicture(const Rectangle& part, const TextEntries& origin) {
  part_ = part;
  origin_ = origin;
}

void Outputs::writeRow(std::span<const float> rgb) {
  const Clock::time_point start = Clock::now();
  if (!rows_) rows_.emplace(format_, part_.width(), part_.height(), pictureStream(), origin_);
  rows_->write(rgb);
  // Which throws: the rest would be rendered for nothing.
  if (std::ferror(pictureStream()) != 0) commitPicture();
  timeOfRows_ += Clock::now() - start;
}

void Outputs::writeRowsOf(Render& render, const Rectangle& crop) {
  float largest = 0.0F;
  if (options_.normalize) {
    render.handOverRows(
        [&](std::span<const float> row) { largest = std::max(largest, *std::ranges::max_element(row)); });
  }
  const auto begin = 3 * static_cast<std::size_t>(part_.x0 - crop.x0);
  std::vector<float> shown(3 * static_cast<std::size_t>(part_.width()));
  const bool hasFalseColors = options_.render.view == View::kCost && !hasNumbers();
  int y = crop.y0;
  render.handOverRows([&](std::span<const float> row) {
    const bool isShown = part_.y0 <= y && y < part_.y1;
    ++y;
    if (!isShown) return;
    std::ranges::copy(row.subspan(begin, shown.size()), shown.begin());
    // Divided, so that the largest is exactly 1.
    if (largest > 0.0F) {
      for (float& value : shown) value /= largest;
    }
    if (hasFalseColors) applyFalseColors(shown);
    writeRow(shown);
  });
}

void Outputs::endPicture(const TextEntries& outcome) {
  rows_->finish(outcome);
  commitPicture();
}

void Outputs::commitPicture() {
  if (output_) return output_->commit();
  if (const std::string reason = stdout_->flush(); !reason.empty())
    throw Error(ExitCode::kOutput, "the image cannot be written to stdout: " + reason);
}

void Outputs::writeFilm(const Render& render, const Identity& identity) {
  render.writeFilm(output_->stream(), identity);
  output_->commit();
}

}  // namespace lavaray
