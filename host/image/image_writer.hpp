#pragma once

#include <cstdio>

#include "image/image.hpp"
#include "image/image_format.hpp"

namespace lavaray {

// Writes a whole image; see RowWriter for what the stream must be and what is thrown. Only PNG and EXR files
// hold the texts.
void writeImage(const Image& image, ImageFormat format, std::FILE* stream, const TextEntries& texts = {});

}  // namespace lavaray
