#pragma once

#include <array>
#include <exception>
#include <string>

#include "base/printable.hpp"

namespace lavaray {

// What reading and writing EXR files have in common.
//
// EXR files hold linear light: a viewer shows 0.214 as it shows a PNG's 0.5. So colours, which are what a
// display is sent (sRGB), are decoded when they are written, and encoded when they are read.

// OpenEXR's threads are the process's, and rendering has its own.
inline constexpr int kNoExrThreads = 0;

inline constexpr std::array<const char*, 3> kExrColors = {"R", "G", "B"};
inline constexpr const char* kExrGrey = "Y";

// The text by which a file says that it holds numbers that are no light: they are read as they are.
inline constexpr const char* kExrLayer = "Layer";

// What an exception of OpenEXR's says, without the sentence that only names the file.
inline std::string reasonOf(const std::exception& error) {
  const std::string text = error.what();
  const std::size_t end = text.find("\". ");
  return printable(end == std::string::npos ? text : text.substr(end + 3));
}

}  // namespace lavaray
