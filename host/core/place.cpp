#include "core/place.hpp"

#include "core/errors.hpp"

namespace lavaray {

std::string messageAt(const Place& place, std::string_view message) {
  return place.file.string() + ":" + std::to_string(place.line) + ": " + std::string(message);
}

void failAt(const Place& place, std::string_view message) {
  throw Error(ExitCode::kInput, messageAt(place, message));
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string result = "\"";
  for (const char c : text.substr(0, kLongest)) {
    const bool isControl = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    result += isControl ? '?' : c;
  }
  if (text.size() > kLongest) result += "...";
  return result + "\"";
}

std::string ticked(std::string_view word) {
  std::string result = "`";
  result += word;
  return result + "`";
}

}  // namespace lavaray
