#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <vector>

#include "image/encoded_image.hpp"
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

// An image of any PNG format, in full depth, with the texts before and behind the pixels; a grey image has
// three equal channels. The numbers are those of the file: what a chunk says of their gamma and colour space
// is not applied. Throws Error(kInput) where the file cannot be read as PNG.
Image readPng(const ImageBytes& file);

}  // namespace lavaray
