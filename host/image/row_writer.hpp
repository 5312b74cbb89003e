#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <vector>

#include "image/exr_writer.hpp"
#include "image/image_format.hpp"
#include "image/png_writer.hpp"

namespace lavaray {

// Writes the same bytes as writeImage, row by row from the top, for images that are too large to be held.
class RowWriter {
 public:
  // A stream of a format that has its rows from the bottom to the top, BMP and PFM, must be one of a file, in
  // which places can be gone to. Throws Error(kOutput) where the image is too large for the format. Whether
  // all was written is for the owner of the stream to check.
  RowWriter(ImageFormat format, int width, int height, std::FILE* stream, const TextEntries& texts);

  // The next row, of 3 * width values in [0, 1].
  void write(std::span<const float> rgb);
  // After the last row, with what is to be said of the image and was not known before it; EXR's texts stand
  // before the pixels only.
  void finish(const TextEntries& texts = {});

 private:
  void writeBmpHeader(int width, int height);
  [[nodiscard]] bool isBottomUp() const;
  void writeBlock();

  ImageFormat format_;
  std::FILE* stream_;
  std::unique_ptr<PngWriter> png_;
  std::unique_ptr<ExrWriter> exr_;
  // Rows wait in a block, as the file has them: those of a narrow image would be a system call each.
  std::size_t rowBytes_;
  std::size_t blockRows_;
  std::vector<std::uint8_t> block_;
  std::size_t waiting_ = 0;  // rows in the block
  std::int64_t pixels_ = 0;  // place of the first of them in the file
  std::int64_t rowsLeft_;    // that are not in the file yet
};

}  // namespace lavaray
