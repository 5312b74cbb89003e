#pragma once

#include "image/encoded_image.hpp"
#include "image/image.hpp"

namespace lavaray {

// BMP files of Windows and OS/2: 1 to 32 bits a pixel with a palette or masks, in either order of rows, and
// run lengths. Where no mask says what the fourth byte of a pixel is, it is not looked at. Throws
// Error(kInput).
Image readBmp(const EncodedImage& file);

}  // namespace lavaray
