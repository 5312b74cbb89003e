#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/short_decimal.hpp"
#include "scene/obj_part.hpp"

namespace lavaray {

// The vertices that a corner of a face refers to.
struct ObjCorner {
  ObjIndex position = kObjAbsent;
  ObjIndex normal = kObjAbsent;
};

// A position in an OBJ text. Lines end as those of `Lines` do: with LF, CR LF or a lone CR. Within a
// statement, `\` as a line's last character continues it in the next line, and `#` anywhere starts a comment.
// The functions that take a word advance past it.
class ObjCursor {
 public:
  // The text must end with LF.
  explicit ObjCursor(std::span<const char> text)
      : at_(text.data()), end_(at_ + text.size()), lf_(at_), crsEnd_(at_) {}

  [[nodiscard]] bool isAtEnd() const { return at_ == end_; }
  [[nodiscard]] std::size_t line() const { return line_; }  // from 1

  // Throws an ObjProblem at the current line.
  [[noreturn]] void fail(const std::string& message) const;

  void skipByteOrderMark();

  // Skips blanks and then, if it is the line's next word, the keyword. Returns whether it was.
  bool takeKeyword(std::string_view keyword) {
    while (isBlank(*at_)) ++at_;
    const char* word = at_;
    for (const char c : keyword) {
      if (*word++ != c) return false;  // stops at an LF at the latest
    }
    if (!endsWord(*word)) return false;
    at_ = word;
    return true;
  }

  // Advances to the statement's next word; false if it has no more.
  bool findWord() {
    for (;;) {
      while (isBlank(*at_)) ++at_;
      if (*at_ != '\\') return !endsWord(*at_);
      if (!continueLine()) return false;
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

  // v, v/vt, v//vn or v/vt/vn; whatever follows a slash may be missing.
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

  // Advances to the start of the next line.
  void skipLine() {
    if (!isLineEnd(*at_)) at_ = lineEnd();
    at_ = afterLineEnd();
    ++line_;
  }

 private:
  static bool isBlank(char c) { return c == ' ' || c == '\t'; }
  static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
  static bool endsWord(char c) { return isBlank(c) || isLineEnd(c) || c == '#' || c == '\\'; }

  // False if there is no integer. One that cannot be an index becomes kObjWrong.
  bool takeIndex(ObjIndex& index) {
    const bool isNegative = *at_ == '-';
    if (isNegative || *at_ == '+') ++at_;
    const char* const first = at_;
    std::int32_t value = 0;
    // Longer ones are read again by takeLongIndex.
    constexpr std::ptrdiff_t kMaxDigits = 9;
    while (isDigit(*at_) && at_ - first < kMaxDigits) value = 10 * value + (*at_++ - '0');
    index = isNegative ? -value : value;
    if (isDigit(*at_)) index = takeLongIndex(first, isNegative);
    return at_ != first;
  }

  bool continueLine();
  double takeUnusualNumber();
  ObjIndex takeLongIndex(const char* digits, bool isNegative);
  [[noreturn]] void failCorner(const char* word) const;
  [[noreturn]] void failPosition(const char* word) const;
  [[nodiscard]] const char* lineEnd();
  [[nodiscard]] const char* afterLineEnd();

  const char* at_;
  const char* end_;
  // Searched for once, not for every line that ends with a lone CR: such a text would be scanned again and
  // again.
  const char* lf_;      // the next LF; out of date if before at_
  const char* crsEnd_;  // end of the run of CRs at at_; out of date if not after at_
  std::size_t line_ = 1;
};

}  // namespace lavaray
