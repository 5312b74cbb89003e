#pragma once

#include "image/encoded_image.hpp"
#include "image/image.hpp"

namespace lavaray {

// An image of any PNG format, in full depth, with the texts before and behind the pixels; a grey image has
// three equal channels. The numbers are those of the file: what a chunk says of their gamma and colour space
// is not applied. Throws Error(kInput) where the file cannot be read as PNG.
Image readPng(const EncodedImage& file);

}  // namespace lavaray
