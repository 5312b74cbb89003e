#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/text_location.hpp"

namespace lavaray {

// Numbers as text, the same in every locale: the decimal point is a point.

// A decimal number such as 1, -0.5, +.5 or 2e3, infinity or NaN; one too small for a double is 0, one too
// large is infinite. Nothing where the word is anything else.
std::optional<double> parseDecimal(std::string_view word);

// What is said of a word where a number belongs, and of a number that is not within +-kMaxMagnitude.
std::string notANumber(std::string_view word);
std::string outOfRange(std::string_view word);

// parseDecimal's number. Throws Error(kInput) at `place` where there is none, or none within +-kMaxMagnitude.
double parseNumber(std::string_view word, const TextLocation& location);

// A decimal integer within the range of int, or nothing.
std::optional<int> parseInteger(std::string_view word);

// Shortest text that reads back as the same number.
std::string numberText(double number);

}  // namespace lavaray
