#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "image/image.hpp"
#include "image/png_writer.hpp"

namespace lavaray {

enum class ImageFormat {
  kBmp,      // 8 bits a channel: trunc(255 c)
  kPng,      // likewise
  kPpm,      // likewise
  kPfm,      // the float values as they are
  kExr,      // the linear light of the values, see exr_file.hpp
  kExrHalf,  // likewise, 16 bits a channel; no ending means this one
};

inline constexpr const char* kImageFormatNames = ".bmp, .png, .ppm, .pfm, .exr";

// By the ending of the name, whatever its case; nothing for any other ending.
std::optional<ImageFormat> imageFormat(const std::filesystem::path& file);

std::string formatName(ImageFormat format);

// Throws Error(kOutput) where the image is too large for the format. Whether all was written is for the owner
// of the stream to check. Of the formats only PNG and EXR have texts.
void writeImage(const Image& image, ImageFormat format, std::FILE* stream, const TextEntries& texts = {});

// Throws Error(kOutput) where a BMP file would be larger than its header can say.
void checkBmpSize(int width, int height);

// Of any of the formats, PGM and PBM, in full depth; the file's bytes say which, whatever its ending. An
// integer v of a file becomes v / maximum, rounded once. Throws Error(kInput) where the file cannot be read,
// is damaged, or is of another format or of a variant that is not read.
Image readImage(const std::filesystem::path& file);
// The same of the file's bytes; `file` is its name for messages.
Image parseImage(std::string_view bytes, const std::filesystem::path& file);

// Of a value in [0, 1].
inline std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(255.0 * static_cast<double>(value));
}

}  // namespace lavaray
