#pragma once

#include "image/image.hpp"

namespace lavaray {

// Throw Error(kUsage) if an image's arrays are not as long as its size says; if two images differ in size.
void checkValues(const Image& image);
void checkSameSize(const Image& image, const Image& reference);

}  // namespace lavaray
