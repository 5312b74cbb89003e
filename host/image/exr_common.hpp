#pragma once

#include <array>
#include <exception>
#include <string>

#include "base/printable.hpp"

namespace lavaray {

// What reading and writing EXR files have in common.
//
// EXR files hold linear light: a viewer shows 0.214 just as it shows 0.5 from a PNG. Colours here are what is
// sent to a display (sRGB), so they are decoded to linear light when written, and encoded when read.

// OpenEXR's threads are global to the process, and rendering has its own.
inline constexpr int kNoExrThreads = 0;

inline constexpr std::array<const char*, 3> kExrColors = {"R", "G", "B"};
inline constexpr const char* kExrGrey = "Y";

// The header text that marks a file as holding numbers instead of light, which are read unchanged.
inline constexpr const char* kExrLayer = "Layer";

// The message of an OpenEXR exception, without the sentence that only names the file.
inline std::string reasonOf(const std::exception& error) {
  const std::string text = error.what();
  const std::size_t end = text.find("\". ");
  return printable(end == std::string::npos ? text : text.substr(end + 3));
}

}  // namespace lavaray
