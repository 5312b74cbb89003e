#pragma once

#include <filesystem>
#include <string_view>

#include "image/image.hpp"

namespace lavaray {

// Reads BMP, PNG, PPM, PGM, PBM, PFM and EXR files in full depth; the file's bytes decide which format it is,
// whatever its extension. An integer v of a file becomes v / maximum, rounded once. Throws Error(kInput) if
// the file cannot be read, is damaged, or is of another format or an unsupported variant.
Image readImage(const std::filesystem::path& file);

// The same from the file's bytes; `file` is its name for messages.
Image parseImage(std::string_view bytes, const std::filesystem::path& file);

// Whether the file's extension is one of those of the formats that are read.
bool hasImageExtension(const std::filesystem::path& file);

}  // namespace lavaray
