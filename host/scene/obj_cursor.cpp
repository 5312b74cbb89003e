#include "scene/obj_cursor.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "base/limits.hpp"
#include "base/number_text.hpp"
#include "base/text_lines.hpp"
#include "base/text_location.hpp"

namespace lavaray {
namespace {

// The text up to the first of these characters.
std::string_view upTo(std::string_view ends, const char* begin, const char* end) {
  const std::string_view text(begin, end);
  return text.substr(0, text.find_first_of(ends));
}

std::string_view wordAt(const char* begin, const char* end) {
  return upTo(" \t\r\n#\\", begin, end);
}

// The rest of infinity or NaN as older Windows C libraries write them, after "1." or "-1."; empty if it is
// not that. The # does not start a comment there.
std::string_view oldNotFinite(std::string_view text) {
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n\\"));
  for (const std::string_view name : {"#INF", "#IND", "#QNAN", "#SNAN"}) {
    if (word.starts_with(name) && word.find_first_not_of("0123456789", name.size()) == std::string_view::npos)
      return word;
  }
  return {};
}

}  // namespace

void ObjCursor::fail(const std::string& message) const {
  throw ObjProblem{line_, message};
}

void ObjCursor::failCorner(const char* word) const {
  fail(quoted(wordAt(word, end_)) + " is not a corner of a face, allowed are v, v/vt, v//vn and v/vt/vn");
}

void ObjCursor::failPosition(const char* word) const {
  const std::string_view corner = wordAt(word, end_);
  const std::string_view index = corner.substr(0, corner.find('/'));
  if (index.find_first_of("123456789") != std::string_view::npos)
    fail("index " + quoted(index) + " is out of range");
  fail("index 0 in " + quoted(corner) + ", allowed are 1, 2, ... or -1, -2, ... from the end");
}

void ObjCursor::skipByteOrderMark() {
  if (std::string_view(at_, end_).starts_with(kByteOrderMark)) at_ += kByteOrderMark.size();
}

// Advances from `\` to the start of the next line; false if there is none.
bool ObjCursor::continueLine() {
  ++at_;
  if (!isLineEnd(*at_))
    fail("`\\` in the middle of a line, which goes on in the next one where `\\` ends it");
  const char* const next = afterLineEnd();
  if (next == end_) return false;
  at_ = next;
  ++line_;
  return true;
}

// Handles whatever is long, has an exponent, is not finite or is not a number.
double ObjCursor::takeUnusualNumber() {
  const std::string_view word = wordAt(at_, end_);
  const std::optional<double> number = parseDecimal(word);
  if (!number) fail(notANumber(word));
  if (std::isfinite(*number) && std::abs(*number) > kMaxMagnitude) fail(outOfRange(word));
  at_ += word.size();
  if (word != "1." && word != "-1.") return *number;
  const std::string_view rest = oldNotFinite({at_, end_});
  at_ += rest.size();
  return rest.empty() ? *number : std::numeric_limits<double>::quiet_NaN();
}

ObjIndex ObjCursor::takeLongIndex(const char* digits, bool isNegative) {
  while (isDigit(*at_)) ++at_;
  const std::optional<int> index = parseInteger({digits, at_});
  return index ? (isNegative ? -*index : *index) : kObjWrong;
}

void ObjCursor::skipWords() {
  const char* const end = lineEnd();
  if (std::memchr(at_, '\\', static_cast<std::size_t>(end - at_)) == nullptr) {
    at_ = end;
    return;
  }
  while (findWord()) at_ += wordAt(at_, end_).size();
}

const char* ObjCursor::lineEnd() {
  const auto find = [](const char* begin, char c, const char* end) {
    return static_cast<const char*>(std::memchr(begin, c, static_cast<std::size_t>(end - begin)));
  };
  if (lf_ < at_ || *lf_ != '\n') lf_ = find(at_, '\n', end_);
  const char* const cr = find(at_, '\r', lf_);
  return cr == nullptr ? lf_ : cr;
}

// at_ is at the line's end. CRs before an LF belong to it.
const char* ObjCursor::afterLineEnd() {
  if (*at_ == '\n') return at_ + 1;
  if (crsEnd_ <= at_) {
    crsEnd_ = at_;
    while (*crsEnd_ == '\r') ++crsEnd_;
  }
  return *crsEnd_ == '\n' ? crsEnd_ + 1 : at_ + 1;
}

}  // namespace lavaray
