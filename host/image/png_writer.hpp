#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <vector>

#include "image/image.hpp"

namespace lavaray {

// Writes a PNG file row by row, 8 bits a channel, and the texts: as tEXt, or as iTXt, which is UTF-8, where
// one is not ASCII. Throws Error(kOutput) for what libpng refuses; whether all was written is for the owner
// of the stream to check.
class PngWriter {
 public:
  PngWriter(int width, int height, const TextEntries& texts, std::FILE* stream);
  ~PngWriter();
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  // The next row, of 3 * width values.
  void writeRow(std::span<const float> rgb);
  // After the last row; these texts are written behind the pixels.
  void finish(const TextEntries& texts);

 private:
  struct Library;
  std::unique_ptr<Library> library_;
  std::FILE* stream_;
  std::vector<std::uint8_t> row_;
};

void writePng(const Image& image, const TextEntries& texts, std::FILE* stream);

}  // namespace lavaray
