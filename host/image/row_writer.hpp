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

// Writes an image file row by row from the top, so that the image need not be in memory as a whole.
class RowWriter {
 public:
  // For BMP and PFM, which store rows from the bottom up, and for EXR the stream must be seekable. Throws
  // Error(kOutput) if the image is too large for the format. Whether everything was written is for the
  // stream's owner to check.
  RowWriter(ImageFormat format, int width, int height, std::FILE* stream, const TextEntries& texts);

  // The next row, of 3 * width values in [0, 1].
  void write(std::span<const float> rgb);
  // After the last row, with texts that were not known before it. EXR cannot take these, as its texts precede
  // the pixels.
  void finish(const TextEntries& texts = {});

 private:
  void writeBmpHeader(int width, int height);
  [[nodiscard]] bool isBottomUp() const;
  void writeBlock();

  ImageFormat format_;
  std::FILE* stream_;
  std::unique_ptr<PngWriter> png_;
  std::unique_ptr<ExrWriter> exr_;
  // Rows are collected in a block, in file order: otherwise each row of a narrow image would cost a system
  // call.
  std::size_t rowBytes_;
  std::size_t blockRows_;
  std::vector<std::uint8_t> block_;
  std::size_t waiting_ = 0;  // rows in the block
  std::int64_t pixels_ = 0;  // position in the file where the pixels begin
  std::int64_t rowsLeft_;    // not written to the file yet
};

}  // namespace lavaray
