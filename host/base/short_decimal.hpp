#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lavaray {

inline bool isDigit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}

// Reads a decimal number without an exponent, such as -12.5, that is short enough to become the nearest
// double in a single rounding: W. D. Clinger, "How to Read Floating Point Numbers Accurately" (1990). Returns
// the end of the number, or null if there is none at `text` or it is longer. The character that ends the
// number must be readable.
inline const char* scanShortDecimal(const char* text, double& number) {
  // All of these are exact doubles, as 5^19 < 2^53.
  static constexpr std::array<double, 20> kPowersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,
                                                       1e7,  1e8,  1e9,  1e10, 1e11, 1e12, 1e13,
                                                       1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
  const bool isNegative = *text == '-';
  text += isNegative ? 1 : 0;
  std::uint64_t digits = 0;
  const char* const first = text;
  for (; isDigit(*text); ++text) digits = 10 * digits + static_cast<std::uint64_t>(*text - '0');
  std::ptrdiff_t count = text - first;
  std::ptrdiff_t decimals = 0;
  if (*text == '.') {
    const char* const point = text++;
    for (; isDigit(*text); ++text) digits = 10 * digits + static_cast<std::uint64_t>(*text - '0');
    decimals = text - point - 1;
    count += decimals;
  }
  // Up to 19 digits do not overflow, so the second comparison sees their true value.
  if (count == 0 || count > 19 || digits > std::uint64_t{1} << 53U) return nullptr;
  number = static_cast<double>(digits) / kPowersOfTen[static_cast<std::size_t>(decimals)];
  if (isNegative) number = -number;
  return text;
}

}  // namespace lavaray
