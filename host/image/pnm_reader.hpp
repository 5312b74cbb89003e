#pragma once

#include "image/encoded_image.hpp"
#include "image/image.hpp"

namespace lavaray {

// The formats of netpbm: PBM (P1, P4), PGM (P2, P5) and PPM (P3, P6), as text or binary, with any maximum
// from 1 to 65535. A grey image has three equal channels. Throws Error(kInput).
Image readPnm(const ImageBytes& file);

// PFM, in colour (PF) and grey (Pf), of either byte order, with a scale of 1. Throws Error(kInput).
Image readPfm(const ImageBytes& file);

}  // namespace lavaray
