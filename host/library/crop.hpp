#pragma once

#include "base/rectangle.hpp"

namespace lavaray {

// Throws Error(kUsage) if the rectangle is empty or not within an image of that size.
void checkWithin(const Rectangle& part, const ImageSize& size);

}  // namespace lavaray
