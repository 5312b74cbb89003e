#pragma once

#include <memory>
#include <string>

#include "image/image_file.hpp"
#include "image/output_file.hpp"

namespace lavaray {

// Where the picture goes: a file that is replaced as a whole, or stdout. Made before the rendering, so that a
// folder that cannot be written to is found out before the work.
class PictureOutput {
 public:
  // `name` is a path with the ending of an image format, or "-" for PPM to stdout.
  explicit PictureOutput(const std::string& name);
  // Throws Error(kOutput) where not everything could be written.
  void write(const Image& image, const TextEntries& origin);

 private:
  std::unique_ptr<OutputFile> file_;
  ImageFormat format_ = ImageFormat::kPpm;
};

}  // namespace lavaray
