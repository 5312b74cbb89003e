#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <vector>

#include "image/image_file.hpp"

namespace lavaray {

// Writes the same bytes as writeImage, row by row, for images that are too large to be held.
class RowWriter {
 public:
  // Throws Error(kOutput) where the image is too large for the format. Whether all was written is for the
  // owner of the stream to check.
  RowWriter(ImageFormat format, int width, int height, std::FILE* stream, const TextEntries& texts);

  // Whether the rows are to come from the bottom to the top.
  [[nodiscard]] bool isBottomUp() const;
  // The next row, of 3 * width values in [0, 1].
  void write(std::span<const float> rgb);
  void finish();

 private:
  void writeBmpHeader(int width, int height);

  ImageFormat format_;
  std::FILE* stream_;
  std::unique_ptr<PngWriter> png_;
  std::vector<std::uint8_t> row_;  // as the file has it
};

}  // namespace lavaray
