#pragma once

#include <cstdint>

#include "base/rectangle.hpp"

namespace lavaray {

// This room holds images in memory, reads and writes them in files, and tells how two of them differ. A
// reader gives every integer of a file as its quotient by the maximum, rounded once; for whatever readers
// disagree about, it adds a note. Files that are damaged, even on purpose, are refused before they cost more
// memory than a file of their size can need.

using v0::Image;
using v0::ImageSource;
using v0::TextEntries;

// Scales the values so that the largest becomes 1; a black image stays black. Returns the former largest
// value, or 0.
float normalize(Image& image);

// The 8-bit level of a value in [0, 1].
inline std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(255.0 * static_cast<double>(value));
}

// The part of the image inside the rectangle, which lies within it.
Image crop(const Image& image, const Rectangle& part);

}  // namespace lavaray
