#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <lavaray/types.h>

namespace lavaray {

using v0::ImageFormat;
using v0::kImageFormatNames;

// By the file's extension, in upper or lower case; empty for any other extension.
std::optional<ImageFormat> imageFormat(const std::filesystem::path& file);

std::string lowerCaseExtension(const std::filesystem::path& file);

std::string formatName(ImageFormat format);

// Throws Error(kOutput) if a BMP file would be larger than its header can state.
void checkBmpSize(int width, int height);

}  // namespace lavaray
