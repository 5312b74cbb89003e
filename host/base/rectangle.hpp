#pragma once

#include <cstdint>

namespace lavaray {

struct ImageSize {
  int width = 0;  // in pixels
  int height = 0;
  bool operator==(const ImageSize&) const = default;
};

// The pixels x0 <= x < x1, y0 <= y < y1 of an image; y counts from the top.
struct Rectangle {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
  bool operator==(const Rectangle&) const = default;

  [[nodiscard]] int width() const { return x1 - x0; }
  [[nodiscard]] int height() const { return y1 - y0; }
  [[nodiscard]] std::uint64_t pixels() const {
    return static_cast<std::uint64_t>(width()) * static_cast<std::uint64_t>(height());
  }
};

}  // namespace lavaray
