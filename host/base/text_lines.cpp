#include "base/text_lines.hpp"

#include <algorithm>

#include "base/text_location.hpp"

namespace lavaray {
namespace {

constexpr std::string_view kWhiteSpace = " \t";

}  // namespace

void rejectNulBytes(std::string_view text, const std::filesystem::path& file) {
  const std::size_t position = text.find('\0');
  if (position == std::string_view::npos) return;
  // The text up to and including the byte ends in the byte's line.
  failAtNulByte({file, countLines(text.substr(0, position + 1))});
}

void failAtNulByte(const TextLocation& location) {
  failAt(location, "a NUL byte, allowed is plain text in ASCII or UTF-8");
}

Lines::Lines(std::string_view text) : text_(text) {
  if (text.starts_with(kByteOrderMark)) position_ = kByteOrderMark.size();
  findLf();
}

void Lines::findLf() {
  lf_ = std::min(text_.find('\n', position_), text_.size());
  beforeCrs_ = lf_;
  while (beforeCrs_ > position_ && text_[beforeCrs_ - 1] == '\r') --beforeCrs_;
}

bool Lines::next() {
  if (position_ >= text_.size()) return false;
  line_ = text_.substr(position_, beforeCrs_ - position_);
  ++number_;
  if (const std::size_t loneCr = line_.find('\r'); loneCr != std::string_view::npos) {
    line_ = line_.substr(0, loneCr);
    position_ += loneCr + 1;
  } else {
    position_ = lf_ + 1;
    if (position_ < text_.size()) findLf();
  }
  return true;
}

std::size_t countLines(std::string_view text) {
  Lines lines(text);
  while (lines.next()) {
  }
  return lines.lineNumber();
}

std::string_view trim(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kWhiteSpace);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kWhiteSpace) - begin + 1);
}

std::string_view takeWord(std::string_view& rest) {
  const std::size_t begin = std::min(rest.find_first_not_of(kWhiteSpace), rest.size());
  const std::size_t end = std::min(rest.find_first_of(kWhiteSpace, begin), rest.size());
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

}  // namespace lavaray
