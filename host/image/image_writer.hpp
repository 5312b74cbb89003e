#pragma once

#include <cstdio>

#include "image/image.hpp"
#include "image/image_format.hpp"

namespace lavaray {

// Throws Error(kOutput) if the image is too large for the format. Whether everything was written is for the
// owner of the stream to check. Only PNG and EXR files hold the texts.
void writeImage(const Image& image, ImageFormat format, std::FILE* stream, const TextEntries& texts = {});

}  // namespace lavaray
