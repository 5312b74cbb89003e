#pragma once

#include <string>
#include <string_view>

namespace lavaray {

// Makes the user's text safe to print on one line of a terminal: control characters become question marks.
inline std::string shown(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return result;
}

}  // namespace lavaray
