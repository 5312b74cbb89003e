#pragma once

#include "image/encoded_image.hpp"
#include "image/image.hpp"

namespace lavaray {

// Reads netpbm's formats PBM (P1, P4), PGM (P2, P5) and PPM (P3, P6), text or binary, with any maximum from 1
// to 65535. A grey image has three equal channels. Throws Error(kInput).
Image readPnm(const EncodedImage& file);

}  // namespace lavaray
