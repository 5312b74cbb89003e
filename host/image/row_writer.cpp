#include "image/row_writer.hpp"

#include <sys/types.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>

#include "base/errors.hpp"
#include "image/byte_order.hpp"

namespace lavaray {
namespace {

constexpr std::size_t kBmpHeaderBytes = 54;
constexpr std::size_t kBlockBytes = std::size_t{1} << 18U;

// A BMP row takes a multiple of four bytes.
std::size_t rowBytes(ImageFormat format, int width) {
  const std::size_t values = std::size_t{3} * width;
  if (format == ImageFormat::kPfm) return values * sizeof(float);
  return format == ImageFormat::kBmp ? (values + 3) / 4 * 4 : values;
}

void toBigEndianFloats(std::span<const float> values, std::uint8_t* bytes) {
  for (const float value : values) {
    putBigEndian(std::bit_cast<std::uint32_t>(value), bytes);
    bytes += sizeof value;
  }
}

void toBlueGreenRed(std::span<const float> rgb, std::uint8_t* bytes) {
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    bytes[i] = toByte(rgb[i + 2]);
    bytes[i + 1] = toByte(rgb[i + 1]);
    bytes[i + 2] = toByte(rgb[i]);
  }
}

}  // namespace

RowWriter::RowWriter(ImageFormat format, int width, int height, std::FILE* stream, const TextEntries& texts)
    : format_(format),
      stream_(stream),
      rowBytes_(rowBytes(format, width)),
      blockRows_(std::clamp(kBlockBytes / rowBytes_, std::size_t{1}, static_cast<std::size_t>(height))),
      rowsLeft_(height) {
  switch (format_) {
    case ImageFormat::kBmp:
      checkBmpSize(width, height);
      writeBmpHeader(width, height);
      break;
    case ImageFormat::kPng:
      png_ = std::make_unique<PngWriter>(width, height, texts, stream);
      return;  // It keeps its own row, as EXR does.
    case ImageFormat::kExr:
    case ImageFormat::kExrHalf:
      exr_ = std::make_unique<ExrWriter>(
          width, height, 3,
          format_ == ImageFormat::kExr ? ExrWriter::Precision::kFloat : ExrWriter::Precision::kHalf, texts,
          stream);
      return;
    case ImageFormat::kPpm:
      std::fprintf(stream_, "P6\n%d %d\n255\n", width, height);
      break;
    case ImageFormat::kPfm:
      std::fprintf(stream_, "PF\n%d %d\n1.0\n", width, height);  // a positive scale: big-endian
      break;
  }
  block_.resize(blockRows_ * rowBytes_);
  if (isBottomUp()) pixels_ = ftello(stream_);
}

void RowWriter::writeBmpHeader(int width, int height) {
  std::array<std::uint8_t, kBmpHeaderBytes> header{'B', 'M'};
  const auto put = [&](std::size_t at, std::uint32_t value, std::size_t bytes) {
    putLittleEndian(value, bytes, &header[at]);
  };
  const auto pixelBytes = static_cast<std::uint32_t>(std::uint64_t{rowBytes_} * height);  // checkBmpSize()
  put(2, kBmpHeaderBytes + pixelBytes, 4);
  put(10, kBmpHeaderBytes, 4);
  put(14, 40, 4);  // size of the second half of the header
  put(18, static_cast<std::uint32_t>(width), 4);
  put(22, static_cast<std::uint32_t>(height), 4);
  put(26, 1, 2);   // planes
  put(28, 24, 2);  // bits per pixel
  put(34, pixelBytes, 4);
  // Pixels per metre, which nobody knows: the number that CImg writes.
  put(38, 256, 4);
  put(42, 256, 4);
  std::fwrite(header.data(), 1, header.size(), stream_);
}

bool RowWriter::isBottomUp() const {
  return format_ == ImageFormat::kBmp || format_ == ImageFormat::kPfm;
}

void RowWriter::write(std::span<const float> rgb) {
  if (png_) return png_->writeRow(rgb);
  if (exr_) return exr_->writeColors(rgb);
  std::uint8_t* const row = &block_[(isBottomUp() ? blockRows_ - 1 - waiting_ : waiting_) * rowBytes_];
  if (format_ == ImageFormat::kPfm) {
    toBigEndianFloats(rgb, row);
  } else if (format_ == ImageFormat::kBmp) {
    toBlueGreenRed(rgb, row);
  } else {
    std::transform(rgb.begin(), rgb.end(), row, toByte);
  }
  if (++waiting_ == blockRows_) writeBlock();
}

void RowWriter::writeBlock() {
  rowsLeft_ -= static_cast<std::int64_t>(waiting_);
  const std::uint8_t* rows = block_.data();
  if (isBottomUp()) {
    rows += (blockRows_ - waiting_) * rowBytes_;
    const std::int64_t position = pixels_ + rowsLeft_ * static_cast<std::int64_t>(rowBytes_);
    if (fseeko(stream_, static_cast<off_t>(position), SEEK_SET) != 0 && std::ferror(stream_) == 0) {
      throw Error(ExitCode::kOutput, std::string("the image cannot be written: ") + std::strerror(errno));
    }
  }
  std::fwrite(rows, 1, waiting_ * rowBytes_, stream_);
  waiting_ = 0;
}

void RowWriter::finish(const TextEntries& texts) {
  if (png_) return png_->finish(texts);
  if (exr_) return exr_->finish();
  if (waiting_ > 0) writeBlock();
}

}  // namespace lavaray
