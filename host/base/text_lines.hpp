#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "base/text_location.hpp"

namespace lavaray {

// Throws Error(kInput) at the line of the first NUL byte. What has one is no text, or text in UTF-16.
void rejectNulBytes(std::string_view text, const std::filesystem::path& file);
[[noreturn]] void failAtNulByte(const TextLocation& location);

// Walks through the lines of a text, or of a part of it that `linesBefore` lines precede. A line ends with
// LF, CR LF, a lone CR or the end of the text; a UTF-8 byte-order mark in front of the first is skipped.
// Refers to the text, which must outlive it.
class Lines {
 public:
  explicit Lines(std::string_view text, std::size_t linesBefore = 0);

  // Goes on to the next line, first of all to the first. False where there is none.
  bool next();

  [[nodiscard]] std::string_view line() const { return line_; }     // without its end
  [[nodiscard]] std::size_t lineNumber() const { return number_; }  // from 1

 private:
  void findLf();

  std::string_view text_;
  std::size_t position_ = 0;  // of the line after this one
  // Looked for once, not for each line that a lone CR ends: such a file would be read again and again.
  std::size_t lf_ = 0;         // the next one, or the end of the text
  std::size_t beforeCrs_ = 0;  // where the CRs before it begin
  std::string_view line_;
  std::size_t number_;
};

std::size_t countLines(std::string_view text);

// Without white space (blanks and tabs) at both ends.
std::string_view trim(std::string_view text);

// Cuts the first word off `rest`; empty where there is none.
std::string_view takeWord(std::string_view& rest);

}  // namespace lavaray
