#pragma once

#include "image/encoded_image.hpp"
#include "image/image.hpp"

namespace lavaray {

// Reads an EXR image of R, G, B, or of Y alone, which is grey, with or without A, of any compression and
// precision, in scan lines or tiles. Throws Error(kInput) for anything else.
Image readExr(const EncodedImage& file);

}  // namespace lavaray
