#include "base/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "base/limits.hpp"

namespace lavaray {
namespace {

// std::from_chars accepts a minus but not a plus.
std::string_view withoutPlus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

// std::from_chars reports "out of range" for numbers too large and too small alike. This tells them apart by
// the decimal exponent of the leading digit: beyond 1e308 and below 1e-308 its sign is enough.
bool isTooSmall(std::string_view literal) {
  const std::size_t e = std::min(literal.find_first_of("eE"), literal.size());
  const std::string_view mantissa = literal.substr(0, e);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t leading = mantissa.find_first_of("123456789");
  if (leading == std::string_view::npos) return true;

  const std::string_view exponentText = withoutPlus(literal.substr(std::min(e + 1, literal.size())));
  long long exponent = 0;
  const auto end = exponentText.data() + exponentText.size();
  if (std::from_chars(exponentText.data(), end, exponent).ec == std::errc::result_out_of_range) {
    return exponentText.starts_with('-');
  }
  return exponent < static_cast<long long>(leading) - static_cast<long long>(point);
}

}  // namespace

std::optional<double> parseDecimal(std::string_view word) {
  const std::string_view literal = withoutPlus(word);
  const char* const end = literal.data() + literal.size();
  double number = 0.0;
  const auto [stop, error] = std::from_chars(literal.data(), end, number);
  if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    number = isTooSmall(literal) ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return number;
}

std::string notANumber(std::string_view word) {
  return quoted(word) + " is not a number, allowed are decimal numbers such as 1, -0.5 or 2e3";
}

std::string outOfRange(std::string_view word) {
  const std::string limit = numberText(kMaxMagnitude);
  return quoted(word) + " is out of range, allowed are numbers from -" + limit + " to " + limit;
}

double parseNumber(std::string_view word, const TextLocation& location) {
  const std::optional<double> number = parseDecimal(word);
  if (!number) failAt(location, notANumber(word));
  // The comparison is false for NaN.
  if (!(std::abs(*number) <= kMaxMagnitude)) failAt(location, outOfRange(word));
  return *number;
}

std::optional<int> parseInteger(std::string_view word) {
  const std::string_view literal = withoutPlus(word);
  const char* const end = literal.data() + literal.size();
  int integer = 0;
  const auto [stop, error] = std::from_chars(literal.data(), end, integer);
  if (stop != end || error != std::errc()) return std::nullopt;
  return integer;
}

std::string numberText(double number) {
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), result.ptr};
}

}  // namespace lavaray
