#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "image/image.hpp"

namespace lavaray {

// Keyword and text, such as a PNG file carries. A keyword has 1 to 79 characters of ASCII.
using TextEntries = std::vector<std::pair<std::string, std::string>>;

// Writes 8 bits a channel and the texts: as tEXt, or as iTXt, which is UTF-8, where one is not ASCII. Throws
// Error(kOutput) for what libpng refuses; whether all was written is for the owner of the stream to check.
void writePng(const Image& image, const TextEntries& texts, std::FILE* stream);

// The texts that stand before the pixels, where writePng puts them. Throws Error(kInput) where the file
// cannot be read as PNG.
TextEntries readPngTexts(const std::filesystem::path& file);

}  // namespace lavaray
