#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/rectangle.hpp"

namespace lavaray {

// Keyword and text, such as a PNG file carries. A keyword has 1 to 79 characters of ASCII.
using TextEntries = std::vector<std::pair<std::string, std::string>>;

// What the file that an image was read from says beside its pixels.
struct ImageSource {
  std::string format;  // "PNG", say; empty for an image that was not read
  // The integers of the file that stand for 1, of red, green, blue and alpha; 0 where it holds floats.
  std::array<std::uint32_t, 4> maxima{};
  // What programs treat in different ways, and what was done here: for the user to know.
  std::vector<std::string> notes;
  TextEntries texts;
};

// Colours in [0, 1], three floats a pixel, row by row from the top. Those of a file of floats may be
// anything.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
  std::vector<float> alpha{};  // one a pixel; empty where the image has none: it is opaque
  ImageSource source{};
};

// Stretches the values so that the largest is 1; a black image stays black. Returns what the largest was, or
// 0.
float normalize(Image& image);

// The 8-bit level of a value in [0, 1].
inline std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(255.0 * static_cast<double>(value));
}

// The part of the image inside the rectangle, which lies within it.
Image crop(const Image& image, const Rectangle& part);

}  // namespace lavaray
