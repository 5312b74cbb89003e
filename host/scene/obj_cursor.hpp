#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/short_decimal.hpp"
#include "scene/obj_part.hpp"

namespace lavaray {

// What a corner of a face names.
struct ObjCorner {
  ObjIndex position = kObjAbsent;
  ObjIndex normal = kObjAbsent;
};

// A place in the lines of an OBJ text. They end as those of `Lines` do: with LF, CR LF or a lone CR. In a
// statement that is read, `\` as the last character of a line makes it go on in the next one, and a comment
// begins wherever `#` stands. What takes a word goes behind it.
class ObjCursor {
 public:
  // The text ends with LF.
  explicit ObjCursor(std::span<const char> text)
      : at_(text.data()), end_(at_ + text.size()), lf_(at_), crsEnd_(at_) {}

  [[nodiscard]] bool isAtEnd() const { return at_ == end_; }
  [[nodiscard]] std::size_t line() const { return line_; }  // from 1

  // Throws an ObjProblem in this line.
  [[noreturn]] void fail(const std::string& message) const;

  void skipByteOrderMark();

  // Goes behind blanks and, if that is the line's next word, the keyword.
  bool takeKeyword(std::string_view keyword) {
    while (isBlank(*at_)) ++at_;
    const char* word = at_;
    for (const char c : keyword) {
      if (*word++ != c) return false;  // an LF at the latest
    }
    if (!endsWord(*word)) return false;
    at_ = word;
    return true;
  }

  // Goes to the next word of a statement; false where it ends.
  bool findWord() {
    for (;;) {
      while (isBlank(*at_)) ++at_;
      if (*at_ != '\\') return !endsWord(*at_);
      if (!goOn()) return false;
    }
  }

  // A number, infinity or NaN.
  double takeNumber() {
    double number = 0.0;
    const char* const end = scanShortDecimal(at_, number);
    if (end == nullptr || (!isBlank(*end) && !isLineEnd(*end))) return takeUnusualNumber();
    at_ = end;
    return number;
  }

  // v, v/vt, v//vn or v/vt/vn; what is behind a slash may be missing.
  ObjCorner takeCorner() {
    const char* const word = at_;
    ObjCorner corner;
    bool isCorner = takeIndex(corner.position);
    if (isCorner && *at_ == '/') {
      ++at_;
      ObjIndex unused = kObjAbsent;
      isCorner = *at_ == '/' || endsWord(*at_) || takeIndex(unused);
      if (isCorner && *at_ == '/') {
        ++at_;
        if (!endsWord(*at_)) {
          isCorner = takeIndex(corner.normal);
          if (corner.normal == kObjAbsent) corner.normal = kObjWrong;
        }
      }
    }
    if (!isCorner || !endsWord(*at_)) failCorner(word);
    if (corner.position == kObjAbsent || corner.position == kObjWrong) failPosition(word);
    return corner;
  }

  void skipWords();

  // Goes behind the end of the line.
  void skipLine() {
    if (!isLineEnd(*at_)) at_ = lineEnd();
    at_ = behindLineEnd();
    ++line_;
  }

 private:
  static bool isBlank(char c) { return c == ' ' || c == '\t'; }
  static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
  static bool endsWord(char c) { return isBlank(c) || isLineEnd(c) || c == '#' || c == '\\'; }

  // False where there is no whole number. One that no index can be is kObjWrong.
  bool takeIndex(ObjIndex& index) {
    const bool isNegative = *at_ == '-';
    if (isNegative || *at_ == '+') ++at_;
    const char* const first = at_;
    std::int32_t value = 0;
    // What is longer is read again.
    constexpr std::ptrdiff_t kMostDigits = 9;
    while (isDigit(*at_) && at_ - first < kMostDigits) value = 10 * value + (*at_++ - '0');
    index = isNegative ? -value : value;
    if (isDigit(*at_)) index = takeLongIndex(first, isNegative);
    return at_ != first;
  }

  bool goOn();
  double takeUnusualNumber();
  ObjIndex takeLongIndex(const char* digits, bool isNegative);
  [[noreturn]] void failCorner(const char* word) const;
  [[noreturn]] void failPosition(const char* word) const;
  [[nodiscard]] const char* lineEnd();
  [[nodiscard]] const char* behindLineEnd();

  const char* at_;
  const char* end_;
  // Looked for once, not for each line that a lone CR ends: such a text would be read again and again.
  const char* lf_;      // the next one, or one before at_
  const char* crsEnd_;  // behind the CRs that follow one another at at_, or not behind at_
  std::size_t line_ = 1;
};

}  // namespace lavaray
