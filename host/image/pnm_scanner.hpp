#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "image/encoded_image.hpp"

namespace lavaray {

// Takes the words of a PNM or PFM file one by one. White space separates them, and a comment, from # to the
// end of its line, may be wherever white space may.
class PnmScanner {
 public:
  // Starts after the two letters that give the file's format.
  explicit PnmScanner(const EncodedImage& file) : file_(file) {}

  // The next word; empty at the end of the file.
  std::string_view word();
  // The next word as an integer. Fails if it is not one from `min` to `max`; the message calls it `name`.
  std::uint32_t number(const char* name, std::uint32_t min, std::uint32_t max);
  // The next digit of a bitmap, 0 or 1; digits need no white space between them.
  std::uint32_t bit();

  // The binary pixels: `size` bytes after a single white-space character (a second one would be a pixel
  // already). Fails if the file has fewer bytes, or more.
  std::string_view pixels(std::uint64_t size);
  // Fails if fewer than `min` bytes are left, the fewest that the pixels take as text.
  void requireText(std::uint64_t min) const;
  // Fails if another word follows.
  void requireEnd();

 private:
  void skipBlanks();

  const EncodedImage& file_;
  std::size_t at_ = 2;
};

}  // namespace lavaray
