#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "image/image.hpp"

namespace lavaray {

// The bytes of an image file that is being read, and the file's name for messages. Refers to both.
struct EncodedImage {
  std::string_view bytes;
  const std::filesystem::path& file;

  // Throws Error(kInput) with the message `file: why`.
  [[noreturn]] void fail(const std::string& why) const;
  [[noreturn]] void failAsCutOff() const;

  // The unsigned number in `count` bytes, 1 to 4. Fails if the file ends before them.
  [[nodiscard]] std::uint32_t littleEndian(std::size_t at, std::size_t count) const;

  // A black image of that size. Fails if a side is beyond what any reader accepts. The caller must check
  // before that the file is long enough for so many pixels, since this allocates the memory.
  [[nodiscard]] Image blankImage(std::int64_t width, std::int64_t height) const;
  void checkSides(std::int64_t width, std::int64_t height) const;
};

// Rounded only once, as integers below 2^24 are exact in a float.
inline float quotient(std::uint32_t value, std::uint32_t maximum) {
  return static_cast<float>(value) / static_cast<float>(maximum);
}

}  // namespace lavaray
