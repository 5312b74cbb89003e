#pragma once

#include <string>
#include <string_view>

namespace lavaray {

// Text of a user's in one line that a terminal prints as it is: control characters are replaced.
inline std::string printable(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return result;
}

}  // namespace lavaray
