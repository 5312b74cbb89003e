#pragma once

#include "image/encoded_image.hpp"
#include "image/image.hpp"

namespace lavaray {

// Reads PFM in colour (PF) or grey (Pf), in either byte order, with a scale of 1. Throws Error(kInput).
Image readPfm(const EncodedImage& file);

}  // namespace lavaray
