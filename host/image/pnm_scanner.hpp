#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "image/encoded_image.hpp"

namespace lavaray {

// The words of a PNM or PFM file: white space separates them, and a comment, from # to the end of its line,
// may stand wherever white space may.
class PnmScanner {
 public:
  // Begins behind the two letters that say the kind of the file.
  explicit PnmScanner(const EncodedImage& file) : file_(file) {}

  // The next word; empty at the end of the file.
  std::string_view word();
  // The next word as an integer; fails, and calls it `name`, where it is none of those allowed.
  std::uint32_t number(const char* name, std::uint32_t min, std::uint32_t max);
  // The next digit of a bitmap, 0 or 1: these may stand side by side.
  std::uint32_t bit();

  // The binary pixels, which take `size` bytes and begin behind one white-space character: more of them would
  // be pixels. Fails where the file has fewer bytes, or more.
  std::string_view pixels(std::uint64_t size);
  // Fails where there are fewer bytes left than `least`, the fewest that the pixels take as text.
  void requireText(std::uint64_t min) const;
  // Fails where another word follows.
  void requireEnd();

 private:
  void skipBlanks();

  const EncodedImage& file_;
  std::size_t at_ = 2;
};

}  // namespace lavaray
