#include "base/short_decimal.hpp"

#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "support/random_numbers.hpp"

namespace lavaray {
namespace {

std::string randomDigits(Random& random, int count) {
  std::string digits;
  for (int i = 0; i < count; ++i) digits += static_cast<char>('0' + random() % 10);
  return digits;
}

// Of up to 20 digits, some of them zeros at the beginning, as often next to 2^53 as anywhere else.
std::string randomDecimal(Random& random) {
  std::string digits;
  if (random() % 2 == 0) {
    digits = randomDigits(random, 1 + static_cast<int>(random() % 20));
  } else {
    digits = std::to_string((std::uint64_t{1} << 53U) - 50 + random() % 100);
    digits.insert(0, random() % 4, '0');
  }
  const auto point = static_cast<std::ptrdiff_t>(random() % (digits.size() + 2));
  if (static_cast<std::size_t>(point) <= digits.size()) digits.insert(digits.begin() + point, '.');
  return (random() % 2 == 0 ? "-" : "") + digits;
}

// The C library's numbers are the nearest ones.
TEST(ShortDecimal, IsTheNearestDouble) {
  Random random(1);
  int shortOnes = 0;
  for (int i = 0; i < 2'000'000; ++i) {
    const std::string text = randomDecimal(random);
    double number = 0.0;
    const char* const end = scanShortDecimal((text + '\n').c_str(), number);
    if (end == nullptr) continue;
    ++shortOnes;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(number),
              std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)))
        << text;
  }
  EXPECT_GT(shortOnes, 1'000'000);
}

TEST(ShortDecimal, EndsBehindTheNumber) {
  for (const std::string number : {"0", "-0", "1.5", ".5", "5.", "-12345678.125", "0000000000000000001"}) {
    for (const std::string rest : {"\n", " 1\n", ".5\n", "e5\n", "x\n", "-\n"}) {
      if (number.find('.') == std::string::npos && rest[0] == '.') continue;
      const std::string text = number + rest;
      double result = 0.0;
      EXPECT_EQ(scanShortDecimal(text.data(), result), text.data() + number.size()) << text;
    }
  }
}

TEST(ShortDecimal, IsNothingElse) {
  for (const std::string text : {"", "-", ".", "-.", "+1", "--1", "nan", "e5", " 1", "9007199254740993",
                                 "0.000000000000000000001", "18446744073709551617", "99999999999999999999"}) {
    double number = 0.0;
    EXPECT_EQ(scanShortDecimal((text + '\n').c_str(), number), nullptr) << text;
  }
}

}  // namespace
}  // namespace lavaray
