#include "core/place.hpp"

#include "core/errors.hpp"

namespace lavaray {

std::string messageAt(const Place& place, std::string_view message) {
  return printable(place.file.native()) + ":" + std::to_string(place.line) + ": " + std::string(message);
}

void failAt(const Place& place, std::string_view message) {
  throw Error(ExitCode::kInput, messageAt(place, message));
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  return '"' + printable(text.substr(0, kLongest)) + (text.size() > kLongest ? "...\"" : "\"");
}

std::string ticked(std::string_view word) {
  std::string result = "`";
  result += word;
  return result + "`";
}

}  // namespace lavaray
