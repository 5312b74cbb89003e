#pragma once

#include <vector>

namespace lavaray {

// Colours in [0, 1], three floats a pixel, row by row from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
};

// Stretches the values so that the largest is 1; a black image stays black. Returns what the largest was, or 0.
float normalize(Image& image);

struct Rectangle {
  int x0 = 0;  // pixels x0 <= x < x1, y0 <= y < y1, y from the top
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
  bool operator==(const Rectangle&) const = default;
};

// The part of the image inside the rectangle, which lies within it.
Image crop(const Image& image, const Rectangle& part);

// Puts `part` into the image, its first pixel at column x of row y; it lies within.
void paste(const Image& part, int x, int y, Image& image);

}  // namespace lavaray
