#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/rectangle.hpp"

namespace lavaray {

// This room holds images in memory, reads and writes them in files, and tells how two of them differ. A
// reader gives every integer of a file as its quotient by the maximum, rounded once; for whatever readers
// disagree about, it adds a note. Files that are damaged, even on purpose, are refused before they cost more
// memory than a file of their size can need.

// Keywords and texts, such as a PNG file carries. A keyword has 1 to 79 ASCII characters.
using TextEntries = std::vector<std::pair<std::string, std::string>>;

// What the file that an image was read from says apart from its pixels.
struct ImageSource {
  std::string format;  // "PNG", say; empty for an image that was not read
  // The integers of red, green, blue and alpha that stand for 1 in the file; 0 if it holds floats.
  std::array<std::uint32_t, 4> maxima{};
  // For the user: what programs treat in different ways, and what was done here.
  std::vector<std::string> notes;
  TextEntries texts;
};

// Colours in [0, 1], three floats per pixel, row by row from the top. From a file of floats they may be
// anything.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
  std::vector<float> alpha{};  // one per pixel; empty if the image has none, and so is opaque
  ImageSource source{};
};

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
