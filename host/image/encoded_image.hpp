#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "image/image.hpp"

namespace lavaray {

// The bytes of an image file that is being read, and its name for what is said of it. Refers to both.
struct EncodedImage {
  std::string_view bytes;
  const std::filesystem::path& file;

  // Throws Error(kInput) with the message `file: why`.
  [[noreturn]] void fail(const std::string& why) const;
  [[noreturn]] void failAsCutOff() const;

  // The unsigned number of 1 to 4 bytes, the lowest first. Fails where the file ends before.
  [[nodiscard]] std::uint32_t littleEndian(std::size_t at, std::size_t count) const;

  // An image of that size, its colours 0. Fails where a side is none that any reader takes. That the file is
  // long enough for so many pixels is for the caller to check before, as the memory is taken here.
  [[nodiscard]] Image blankImage(std::int64_t width, std::int64_t height) const;
  void checkSides(std::int64_t width, std::int64_t height) const;
};

// Of integers below 2^24, which are floats: the quotient rounded once.
inline float quotient(std::uint32_t value, std::uint32_t maximum) {
  return static_cast<float>(value) / static_cast<float>(maximum);
}

}  // namespace lavaray
