#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/text_location.hpp"

namespace lavaray {

// Numbers as text, the same in every locale: the decimal separator is a point.

// A decimal number such as 1, -0.5, +.5 or 2e3, infinity or NaN. One too small for a double becomes 0, one
// too large infinite. Empty if the word is anything else.
std::optional<double> parseDecimal(std::string_view word);

// The messages about a word that is not a number, and about a number that is not within +-kMaxMagnitude.
std::string notANumber(std::string_view word);
std::string outOfRange(std::string_view word);

// Like parseDecimal, but throws Error(kInput) at `location` if the word is not a number within
// +-kMaxMagnitude.
double parseNumber(std::string_view word, const TextLocation& location);

// A decimal integer; empty if the word is anything else or is out of the range of int.
std::optional<int> parseInteger(std::string_view word);

// The shortest text that reads back as the same number.
std::string numberText(double number);

}  // namespace lavaray
