#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <vector>

#include "image/image.hpp"

namespace lavaray {

// Writes a PNG file row by row with 8 bits per channel. Texts become tEXt chunks, or iTXt, which is UTF-8, if
// they are not ASCII. Throws Error(kOutput) if libpng refuses; whether everything was written is for the
// stream's owner to check.
class PngWriter {
 public:
  PngWriter(int width, int height, const TextEntries& texts, std::FILE* stream);
  ~PngWriter();
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  // The next row, of 3 * width values.
  void writeRow(std::span<const float> rgb);
  // After the last row. These texts follow the pixels.
  void finish(const TextEntries& texts);

 private:
  struct Library;
  std::unique_ptr<Library> library_;
  std::FILE* stream_;
  std::vector<std::uint8_t> row_;
};

}  // namespace lavaray
