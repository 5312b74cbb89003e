#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace lavaray {

// The formats that images are written in.
enum class ImageFormat {
  kBmp,      // 8 bits a channel: trunc(255 c)
  kPng,      // likewise
  kPpm,      // likewise
  kPfm,      // the float values as they are
  kExr,      // the linear light of the values, see exr_writer.hpp
  kExrHalf,  // likewise, 16 bits a channel; no file extension stands for this one
};

inline constexpr const char* kImageFormatNames = ".bmp, .png, .ppm, .pfm, .exr";

// By the file's extension, in upper or lower case; empty for any other extension.
std::optional<ImageFormat> imageFormat(const std::filesystem::path& file);

std::string lowerCaseExtension(const std::filesystem::path& file);

std::string formatName(ImageFormat format);

// Throws Error(kOutput) if a BMP file would be larger than its header can state.
void checkBmpSize(int width, int height);

}  // namespace lavaray
