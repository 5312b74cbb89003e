#include "image/bmp_run_lengths.hpp"

#include <utility>

namespace lavaray {
namespace {

class Runs {
 public:
  Runs(const EncodedImage& file, const BmpHeader& header)
      : file_(file),
        isFourBits_(header.bits == 4),
        at_(header.pixelsAt),
        width_(static_cast<std::size_t>(header.width)),
        pixels_(width_ * static_cast<std::size_t>(header.height)) {
    // Two bytes stand for at most 255 pixels.
    if ((file.bytes.size() - at_) * 128 < pixels_) file.failAsCutOff();
  }

  std::vector<std::uint8_t> read() {
    indices_.reserve(pixels_);
    while (indices_.size() < pixels_) {
      const std::uint8_t count = next();
      const std::uint8_t value = next();
      if (count > 0) {
        run(count, value);
      } else if (value > 2) {
        literal(value);
      } else {
        escape(value);
      }
    }
    return std::move(indices_);
  }

 private:
  std::uint8_t next() {
    if (at_ >= file_.bytes.size()) file_.failAsCutOff();
    return static_cast<std::uint8_t>(file_.bytes[at_++]);
  }

  void requireRoom(std::size_t count) {
    if (indices_.size() - rowBegin_ + count > width_) {
      file_.fail("is a BMP image with a run of pixels that is longer than the rest of its row");
    }
  }

  // With 4 bits per pixel, a run alternates between two colours.
  void run(std::size_t count, std::uint8_t value) {
    requireRoom(count);
    for (std::size_t i = 0; i < count; ++i) indices_.push_back(isFourBits_ ? nibble(value, i) : value);
  }

  // Pixels one by one, padded to an even number of bytes.
  void literal(std::size_t count) {
    requireRoom(count);
    std::uint8_t byte = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (!isFourBits_ || i % 2 == 0) byte = next();
      indices_.push_back(isFourBits_ ? nibble(byte, i) : byte);
    }
    const std::size_t bytes = isFourBits_ ? (count + 1) / 2 : count;
    if (bytes % 2 != 0) (void)next();
  }

  // 0 ends a row, 1 ends the image, 2 steps to the right and up. The last two would leave pixels out here.
  void escape(std::uint8_t code) {
    const std::size_t inRow = indices_.size() - rowBegin_;
    if (code == 0 && inRow == width_) {
      rowBegin_ = indices_.size();
      return;
    }
    file_.fail("is a BMP image whose run lengths leave pixels out; allowed are those that have every pixel");
  }

  static std::uint8_t nibble(std::uint8_t byte, std::size_t i) { return i % 2 == 0 ? byte >> 4 : byte & 0xF; }

  const EncodedImage& file_;
  bool isFourBits_;
  std::size_t at_;
  std::size_t width_;
  std::size_t pixels_;
  std::size_t rowBegin_ = 0;
  std::vector<std::uint8_t> indices_;
};

}  // namespace

std::vector<std::uint8_t> readBmpRuns(const EncodedImage& file, const BmpHeader& header) {
  return Runs(file, header).read();
}

}  // namespace lavaray
