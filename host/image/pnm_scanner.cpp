#include "image/pnm_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "base/text_location.hpp"

namespace lavaray {
namespace {

// Unlike std::isspace, the same in every locale.
bool isBlank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

}  // namespace

void PnmScanner::skipBlanks() {
  const std::string_view bytes = file_.bytes;
  while (at_ < bytes.size() && (isBlank(bytes[at_]) || bytes[at_] == '#')) {
    at_ = bytes[at_] == '#' ? std::min(bytes.find_first_of("\n\r", at_), bytes.size()) : at_ + 1;
  }
}

std::string_view PnmScanner::word() {
  skipBlanks();
  const std::size_t begin = at_;
  const std::string_view bytes = file_.bytes;
  while (at_ < bytes.size() && !isBlank(bytes[at_]) && bytes[at_] != '#') ++at_;
  return bytes.substr(begin, at_ - begin);
}

std::uint32_t PnmScanner::number(const char* name, std::uint32_t min, std::uint32_t max) {
  const std::string_view text = word();
  if (text.empty()) file_.failAsCutOff();
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && value >= min && value <= max) return value;
  file_.fail(std::string(name) + " is " + quoted(text) + "; allowed are the integers from " +
             std::to_string(min) + " to " + std::to_string(max));
}

std::uint32_t PnmScanner::bit() {
  skipBlanks();
  if (at_ == file_.bytes.size()) file_.failAsCutOff();
  const char digit = file_.bytes[at_++];
  if (digit != '0' && digit != '1') {
    file_.fail("a pixel is " + quoted(std::string_view(&digit, 1)) + "; allowed are 0 and 1");
  }
  return digit == '1' ? 1 : 0;
}

std::string_view PnmScanner::pixels(std::uint64_t size) {
  std::string_view rest = file_.bytes.substr(at_);
  if (rest.starts_with('#')) {  // right after the last number: the end of its line is the white space
    rest.remove_prefix(std::min(rest.find_first_of("\n\r"), rest.size()));
  }
  if (!rest.empty()) rest.remove_prefix(1);
  if (rest.size() < size) file_.failAsCutOff();
  const std::string_view after = rest.substr(size);
  // An extra line end or a comment after the header shifts all pixels; an extra line end after the pixels
  // does no harm.
  const bool mayBeHeader = rest.starts_with('\n') || rest.starts_with('#');
  if (!after.empty() && (mayBeHeader || !std::all_of(after.begin(), after.end(), isBlank))) {
    file_.fail("is " + std::to_string(after.size()) +
               " bytes longer than its pixels; allowed are one image a file, "
               "and a single blank or line end between its header and its pixels");
  }
  return rest.substr(0, size);
}

void PnmScanner::requireText(std::uint64_t min) const {
  if (file_.bytes.size() - at_ < min) file_.failAsCutOff();
}

void PnmScanner::requireEnd() {
  const std::string_view text = word();
  if (!text.empty())
    file_.fail("goes on with " + quoted(text) + " after its pixels; allowed is one image a file");
}

}  // namespace lavaray
