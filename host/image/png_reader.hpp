#pragma once

#include "image/encoded_image.hpp"
#include "image/image.hpp"

namespace lavaray {

// Reads an image of any PNG format in full depth, with the texts before and after the pixels; a grey image
// has three equal channels. The numbers are the file's own: what its chunks say about gamma and colour space
// is not applied. Throws Error(kInput) if the file cannot be read as PNG.
Image readPng(const EncodedImage& file);

}  // namespace lavaray
