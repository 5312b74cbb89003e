#include "shader_compiler/compiler_log.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "base/text_lines.hpp"

namespace lavaray {
namespace {

constexpr std::string_view kDigits = "0123456789";

bool isWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::optional<std::size_t> number(std::string_view digits) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

// So that a terminal takes no stray byte of a source for a command.
std::string printable(std::string_view text) {
  std::string result(trim(text));
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return result;
}

bool takePrefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

// Takes `SOURCE:LINE: ` off the text where it begins with that.
void takeLocation(std::string_view& text, CompilerMessage& message) {
  for (std::size_t colon = text.find(':'); colon != std::string_view::npos;
       colon = text.find(':', colon + 1)) {
    const std::size_t end = std::min(text.find_first_not_of(kDigits, colon + 1), text.size());
    const std::optional<std::size_t> line = number(text.substr(colon + 1, end - colon - 1));
    if (!line || colon == 0 || !text.substr(end).starts_with(": ")) continue;
    message.source = text.substr(0, colon);
    message.line = std::max<std::size_t>(*line, 1);
    text.remove_prefix(end + 2);
    return;
  }
}

// Rewrites glslang's `'token' : message`, whose token is empty where there is none.
std::string sentence(std::string_view text) {
  constexpr std::string_view kEndOfToken = "' : ";
  const std::size_t end = text.find(kEndOfToken, 1);
  if (!text.starts_with('\'') || end == std::string_view::npos) return printable(text);
  const std::string_view token = text.substr(1, end - 1);
  std::string_view rest = trim(text.substr(end + kEndOfToken.size()));
  if (token.empty()) return printable(rest);
  if (token.size() == 1 && static_cast<unsigned char>(token[0]) >= 0x80)
    return "a character that is not ASCII, allowed are such in comments only";
  if (token == "#error") return printable("#error " + std::string(rest));
  constexpr std::string_view kHeader = " for header name: ";
  if (const std::size_t header = rest.rfind(kHeader); token == "#include" && header != std::string_view::npos)
    return printable("#include \"" + std::string(rest.substr(header + kHeader.size())) +
                     "\": " + std::string(rest.substr(0, header)));
  return printable("'" + std::string(token) + "': " + std::string(rest));
}

bool isFollowUp(std::string_view text) {
  return text.find("compilation terminated") != std::string_view::npos ||
         text.find("No code generated") != std::string_view::npos;
}

std::optional<CompilerMessage> readMessage(std::string_view line) {
  CompilerMessage message{true, {}, 1, {}, {}};
  if (takePrefix(line, "WARNING: ")) {
    message.isError = false;
  } else if (!takePrefix(line, "ERROR: ") && !takePrefix(line, "INTERNAL ERROR: ") &&
             !takePrefix(line, "UNIMPLEMENTED: ") && !takePrefix(line, "UNKNOWN ERROR: ")) {
    return std::nullopt;
  }
  if (isFollowUp(line)) return std::nullopt;
  takeLocation(line, message);
  takePrefix(line, "Linking compute stage: ");
  message.text = sentence(line);
  return message;
}

}  // namespace

std::vector<CompilerMessage> readCompilerLog(std::string_view log) {
  std::vector<CompilerMessage> messages;
  Lines lines(log);
  while (lines.next()) {
    const std::string_view line = lines.line();
    if (line.starts_with(' ') && !messages.empty() && messages.back().source.empty()) {
      // The functions that the linker's message is about, written `name(types; calling name(types;`.
      const std::string_view functions = trim(line);
      messages.back().function = functions.substr(0, functions.find('('));
      messages.back().text += " " + messages.back().function;
      continue;
    }
    std::optional<CompilerMessage> message = readMessage(line);
    if (!message) continue;
    const bool isKnown = std::ranges::any_of(messages, [&](const CompilerMessage& other) {
      return other.source == message->source && other.line == message->line && other.text == message->text;
    });
    if (!isKnown) messages.push_back(std::move(*message));
  }
  return messages;
}

PreprocessedLocation findWord(std::string_view preprocessed, std::string_view word) {
  PreprocessedLocation location{{}, 1};
  Lines lines(preprocessed);
  while (lines.next()) {
    std::string_view line = lines.line();
    if (takePrefix(line, "#line ")) {
      location.line = number(takeWord(line)).value_or(1);
      line = trim(line);
      if (line.size() >= 2) location.source = line.substr(1, line.size() - 2);
      continue;
    }
    for (std::size_t at = line.find(word); at != std::string_view::npos; at = line.find(word, at + 1)) {
      const std::size_t end = at + word.size();
      const bool isBegun = at > 0 && isWordCharacter(line[at - 1]);
      const bool goesOn = isWordCharacter(word.back()) && end < line.size() && isWordCharacter(line[end]);
      if (!isBegun && !goesOn) return location;
    }
    ++location.line;
  }
  return {{}, 1};
}

}  // namespace lavaray
