#include "base/text_location.hpp"

#include "base/errors.hpp"

namespace lavaray {

std::string messageAt(const TextLocation& location, std::string_view message) {
  return printable(location.file.native()) + ":" + std::to_string(location.line) + ": " +
         std::string(message);
}

void failAt(const TextLocation& location, std::string_view message) {
  throw Error(ExitCode::kInput, messageAt(location, message), location.file.string(), location.line);
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kMaxLength = 60;
  return '"' + printable(text.substr(0, kMaxLength)) + (text.size() > kMaxLength ? "...\"" : "\"");
}

std::string backticked(std::string_view word) {
  std::string result = "`";
  result += word;
  return result + "`";
}

}  // namespace lavaray
