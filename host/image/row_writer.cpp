#include "image/row_writer.hpp"

#include <array>
#include <bit>
#include <cstring>

namespace lavaray {
namespace {

constexpr std::size_t kBmpHeaderBytes = 54;

// BMP's rows have a multiple of four bytes.
std::size_t rowBytes(ImageFormat format, int width) {
  const std::size_t values = std::size_t{3} * width;
  if (format == ImageFormat::kPfm) return values * sizeof(float);
  return format == ImageFormat::kBmp ? (values + 3) / 4 * 4 : values;
}

}  // namespace

RowWriter::RowWriter(ImageFormat format, int width, int height, std::FILE* stream, const TextEntries& texts)
    : format_(format), stream_(stream), row_(rowBytes(format, width)) {
  switch (format_) {
    case ImageFormat::kBmp:
      checkBmpSize(width, height);
      writeBmpHeader(width, height);
      break;
    case ImageFormat::kPng:
      png_ = std::make_unique<PngWriter>(width, height, texts, stream);
      break;
    case ImageFormat::kPpm:
      std::fprintf(stream_, "P6\n%d %d\n255\n", width, height);
      break;
    case ImageFormat::kPfm:
      std::fprintf(stream_, "PF\n%d %d\n1.0\n", width, height);  // a positive scale: big-endian
      break;
  }
}

void RowWriter::writeBmpHeader(int width, int height) {
  std::array<std::uint8_t, kBmpHeaderBytes> header{'B', 'M'};
  const auto put = [&](std::size_t place, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) header[place + i] = static_cast<std::uint8_t>(value >> (8 * i));
  };
  const std::uint64_t pixelBytes = std::uint64_t{row_.size()} * height;
  put(2, kBmpHeaderBytes + pixelBytes, 4);
  put(10, kBmpHeaderBytes, 4);
  put(14, 40, 4);  // bytes of the second half of the header
  put(18, static_cast<std::uint64_t>(width), 4);
  put(22, static_cast<std::uint64_t>(height), 4);
  put(26, 1, 2);   // planes
  put(28, 24, 2);  // bits a pixel
  put(34, pixelBytes, 4);
  // Pixels a metre, of which nothing is known: the number that CImg writes.
  put(38, 256, 4);
  put(42, 256, 4);
  std::fwrite(header.data(), 1, header.size(), stream_);
}

bool RowWriter::isBottomUp() const {
  return format_ == ImageFormat::kBmp || format_ == ImageFormat::kPfm;
}

void RowWriter::write(std::span<const float> rgb) {
  if (png_) {
    png_->writeRow(rgb);
    return;
  }
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    if (format_ == ImageFormat::kPfm) {
      const auto bits = __builtin_bswap32(std::bit_cast<std::uint32_t>(rgb[i]));
      std::memcpy(&row_[4 * i], &bits, sizeof bits);
    } else {
      const std::size_t place = format_ == ImageFormat::kBmp ? i / 3 * 3 + (2 - i % 3) : i;  // blue first
      row_[place] = toByte(rgb[i]);
    }
  }
  std::fwrite(row_.data(), 1, row_.size(), stream_);
}

void RowWriter::finish() {
  if (png_) png_->finish();
}

}  // namespace lavaray
