#include "app/picture_output.hpp"

#include "core/errors.hpp"

namespace lavaray {

PictureOutput::PictureOutput(const std::string& name) {
  if (name == "-") return;
  file_ = std::make_unique<OutputFile>(name);
  format_ = imageFormat(name).value();
}

void PictureOutput::write(const Image& image, const TextEntries& origin) {
  writeImage(image, format_, file_ ? file_->stream() : stdout, origin);
  if (file_) file_->commit();
  if (!file_ && std::fflush(stdout) != 0) {
    throw Error(ExitCode::kOutput, "the image cannot be written to stdout");
  }
}

}  // namespace lavaray
