#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "base/text_location.hpp"

namespace lavaray {

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // in UTF-8

// Throws Error(kInput) at the line of the first NUL byte. Anything with one is not text, or is UTF-16.
void rejectNulBytes(std::string_view text, const std::filesystem::path& file);
[[noreturn]] void failAtNulByte(const TextLocation& location);

// Iterates over the lines of a text. A line ends with LF, CR LF, a lone CR or the end of the text; a UTF-8
// byte-order mark before the first is skipped. Refers to the text, which must outlive it.
class Lines {
 public:
  explicit Lines(std::string_view text);

  // Advances to the next line; the first call goes to the first. False if there is none.
  bool next();

  [[nodiscard]] std::string_view line() const { return line_; }     // without its line end
  [[nodiscard]] std::size_t lineNumber() const { return number_; }  // from 1

 private:
  void findLf();

  std::string_view text_;
  std::size_t position_ = 0;  // start of the line after this one
  // Searched for once, not for every line that ends with a lone CR: such a file would be scanned again and
  // again.
  std::size_t lf_ = 0;         // the next one, or the end of the text
  std::size_t beforeCrs_ = 0;  // start of the run of CRs before it
  std::string_view line_;
  std::size_t number_ = 0;
};

std::size_t countLines(std::string_view text);

// Removes white space (blanks and tabs) from both ends.
std::string_view trim(std::string_view text);

// Removes the first word from `rest` and returns it; empty if there is none.
std::string_view takeWord(std::string_view& rest);

}  // namespace lavaray
