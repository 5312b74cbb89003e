#include "image/bmp_header.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <string>

namespace lavaray {
namespace {

// The versions of the header are told apart by its size: 12 (OS/2 1), 16 and 64 (OS/2 2), 40 (Windows 3), 52
// and 56 (with masks), 108 and 124 (Windows 95 and 98).

constexpr std::size_t kFileHeader = 14;  // bytes

// As the header numbers them; others exist.
enum class Compression : std::uint32_t {
  kNone = 0,
  kRuns8 = 1,
  kRuns4 = 2,
  kBitFields = 3,
  kAlphaBitFields = 6
};

bool isOs2Version2(std::uint32_t headerSize) {
  return headerSize == 16 || headerSize == 64;
}

void checkHeaderSize(const EncodedImage& file, std::uint32_t size) {
  for (const std::uint32_t known : {12U, 16U, 40U, 52U, 56U, 64U, 108U, 124U}) {
    if (size == known) return;
  }
  file.fail("is a BMP image whose header has " + std::to_string(size) +
            " bytes; allowed are 12, 16, 40, 52, 56, 64, 108 and 124");
}

void checkBits(const EncodedImage& file, int bits) {
  for (const int known : {1, 2, 4, 8, 16, 24, 32}) {
    if (bits == known) return;
  }
  file.fail("is a BMP image of " + std::to_string(bits) +
            " bits a pixel; allowed are 1, 2, 4, 8, 16, 24 and 32");
}

// The name of a compression that is not supported.
std::string compressionName(Compression compression, bool isOs2) {
  const auto number = static_cast<std::uint32_t>(compression);
  if (isOs2 && number == 3) return "Huffman codes (OS/2)";
  if (isOs2 && number == 4) return "run lengths of 24 bits (OS/2)";
  if (number == 4) return "a JPEG image inside";
  if (number == 5) return "a PNG image inside";
  if (number >= 11 && number <= 13) return "CMYK colours";
  return "compression number " + std::to_string(number);
}

void checkCompression(const EncodedImage& file, Compression compression, const BmpHeader& header,
                      bool isOs2) {
  const bool mayHaveMasks = (header.bits == 16 || header.bits == 32) && !isOs2;
  const bool isKnown =
      compression == Compression::kNone || compression == Compression::kRuns8 ||
      compression == Compression::kRuns4 ||
      (!isOs2 && (compression == Compression::kBitFields || compression == Compression::kAlphaBitFields));
  const std::string allowed =
      "; allowed are no compression, run lengths of 4 and 8 bits, and masks for 16 and 32 bits";
  if (!isKnown) file.fail("is a BMP image with " + compressionName(compression, isOs2) + allowed);
  const bool fits = compression == Compression::kNone ||
                    (compression == Compression::kRuns8 && header.bits == 8) ||
                    (compression == Compression::kRuns4 && header.bits == 4) ||
                    (compression >= Compression::kBitFields && mayHaveMasks);
  if (!fits) {
    file.fail("is a BMP image whose compression does not go with its " + std::to_string(header.bits) +
              " bits a pixel" + allowed);
  }
  if (header.isRunLength && header.isTopDown) {
    file.fail("is a BMP image of run lengths from the top down; allowed are those from the bottom up");
  }
}

BmpMask maskOf(const EncodedImage& file, std::uint32_t bits, int bitsOfPixel) {
  if (bits == 0) return {};
  const int shift = std::countr_zero(bits);
  const std::uint32_t maximum = bits >> shift;
  const bool isOneRun = (maximum & (maximum + 1)) == 0;
  const bool isInside = bitsOfPixel == 32 || bits < (1U << bitsOfPixel);
  if (!isOneRun || !isInside || std::bit_width(maximum) > 16) {
    file.fail("is a BMP image with a mask that is not 1 to 16 neighbouring bits of its pixels' " +
              std::to_string(bitsOfPixel));
  }
  return {bits, shift, maximum};
}

void readMasks(const EncodedImage& file, std::uint32_t headerSize, Compression compression,
               BmpHeader& header) {
  std::array<std::uint32_t, 4> bits{0xFF0000, 0xFF00, 0xFF, 0};
  if (header.bits == 16) bits = {0x7C00, 0x3E0, 0x1F, 0};
  if (compression >= Compression::kBitFields) {
    const bool hasAlpha = headerSize >= 56 || compression == Compression::kAlphaBitFields;
    for (std::size_t i = 0; i < (hasAlpha ? 4 : 3); ++i)
      bits[i] = file.littleEndian(kFileHeader + 40 + 4 * i, 4);
  }
  std::uint32_t used = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    header.masks[i] = maskOf(file, bits[i], header.bits);
    if ((used & bits[i]) != 0)
      file.fail("is a BMP image whose masks have bits in common; allowed are masks that do not");
    if (i < 3 && bits[i] == 0) file.fail("is a BMP image without a mask for each of red, green and blue");
    used |= bits[i];
  }
  header.hasReservedByte = header.bits == 32 && compression == Compression::kNone;
}

// Some files have a palette shorter than their header says: it ends where the pixels begin.
void readPalette(const EncodedImage& file, std::size_t at, std::size_t entryBytes, std::size_t used,
                 BmpHeader& header) {
  const std::size_t all = std::size_t{1} << header.bits;
  const std::size_t said = used == 0 ? all : std::min(used, all);
  const std::size_t count = std::min(said, (header.pixelsAt - at) / entryBytes);
  if (count == 0) file.fail("is a BMP image without a palette, which images of up to 8 bits a pixel need");
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t color = file.littleEndian(at + entryBytes * i, 3);
    header.palette.push_back({static_cast<std::uint8_t>(color >> 16), static_cast<std::uint8_t>(color >> 8),
                              static_cast<std::uint8_t>(color)});
  }
}

}  // namespace

BmpHeader readBmpHeader(const EncodedImage& file) {
  const std::uint32_t size = file.littleEndian(kFileHeader, 4);
  checkHeaderSize(file, size);
  const bool isShort = size == 12;
  BmpHeader header;
  header.pixelsAt = file.littleEndian(10, 4);
  if (isShort) {
    header.width = file.littleEndian(18, 2);
    header.height = file.littleEndian(20, 2);
  } else {
    header.width = static_cast<std::int32_t>(file.littleEndian(18, 4));
    header.height = static_cast<std::int32_t>(file.littleEndian(22, 4));
  }
  header.isTopDown = header.height < 0;
  header.height = std::abs(header.height);
  file.checkSides(header.width, header.height);
  const std::uint32_t planes = file.littleEndian(isShort ? 22 : 26, 2);
  if (planes != 1) file.fail("is a BMP image of " + std::to_string(planes) + " planes; allowed is 1");
  header.bits = static_cast<int>(file.littleEndian(isShort ? 24 : 28, 2));
  checkBits(file, header.bits);
  const Compression compression{size >= 40 ? file.littleEndian(30, 4) : 0};
  header.isRunLength = compression == Compression::kRuns8 || compression == Compression::kRuns4;
  checkCompression(file, compression, header, isOs2Version2(size));

  std::size_t end = kFileHeader + size;
  if (size == 40 && compression == Compression::kBitFields) end += 12;
  if (size == 40 && compression == Compression::kAlphaBitFields) end += 16;
  if (header.pixelsAt < end) file.fail("is a BMP image whose pixels begin inside its header");
  if (header.pixelsAt > file.bytes.size()) file.failAsCutOff();
  if (header.hasPalette()) {
    readPalette(file, end, isShort ? 3 : 4, size >= 40 ? file.littleEndian(46, 4) : 0, header);
  } else {
    readMasks(file, size, compression, header);
  }
  return header;
}

}  // namespace lavaray
