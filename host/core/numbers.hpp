#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/place.hpp"

namespace lavaray {

// Numbers as text, the same in every locale: the decimal point is a point.

// A decimal number such as 1, -0.5, +.5 or 2e3; one too small for a double is 0. Throws Error(kInput) at
// `place` where the word is anything else, is not finite or is larger than kMaxMagnitude.
double parseNumber(std::string_view word, const Place& place);

// A decimal integer within the range of int, or nothing.
std::optional<int> parseInteger(std::string_view word);

// Shortest text that reads back as the same number.
std::string numberText(double number);

}  // namespace lavaray
