#pragma once

#include "image/encoded_image.hpp"
#include "image/image.hpp"

namespace lavaray {

// The picture in a file of R, G, B, or of Y alone, which is grey, and of A, of any compression and precision,
// in scan lines or tiles. Fails for all else.
Image readExr(const EncodedImage& file);

}  // namespace lavaray
