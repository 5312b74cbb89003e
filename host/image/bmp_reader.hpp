#pragma once

#include "image/encoded_image.hpp"
#include "image/image.hpp"

namespace lavaray {

// Reads BMP files of Windows and OS/2: 1 to 32 bits per pixel with a palette or masks, rows in either order,
// and run lengths. A pixel's fourth byte is ignored if no mask says what it is. Throws Error(kInput).
Image readBmp(const EncodedImage& file);

}  // namespace lavaray
