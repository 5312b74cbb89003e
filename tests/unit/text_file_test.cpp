#include "base/text_lines.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

namespace lavaray {
namespace {

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> result;
  for (Lines lines(text); lines.next();) result.emplace_back(lines.line());
  return result;
}

TEST(Lines, EndWithLfCrLfALoneCrOrTheText) {
  using Expected = std::vector<std::string>;
  EXPECT_EQ(linesOf(""), Expected{});
  EXPECT_EQ(linesOf("a"), Expected{"a"});
  EXPECT_EQ(linesOf("a\n"), Expected{"a"});
  EXPECT_EQ(linesOf("a\r"), Expected{"a"});
  EXPECT_EQ(linesOf("a\n\nb\r\n\r\nc"), (Expected{"a", "", "b", "", "c"}));
  EXPECT_EQ(linesOf("a\rb\r\rc\nd\re"), (Expected{"a", "b", "", "c", "d", "e"}));
  EXPECT_EQ(linesOf("a\r\r\nb\rc\r\r"), (Expected{"a", "b", "c"}));
  EXPECT_EQ(linesOf("\xEF\xBB\xBF"
                    "a\r\xEF\xBB\xBF"),
            (Expected{"a", "\xEF\xBB\xBF"}));
}

double secondsToWalk(const std::string& text) {
  const auto start = std::chrono::steady_clock::now();
  for (Lines lines(text); lines.next();) {
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Not a thousand times as long, as where each line's end is looked for in the rest of the file.
TEST(Lines, OfALargeFileTakeAsLongWhateverEndsThem) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "f 1 2 3\n";
  const double seconds = secondsToWalk(text);
  for (char& c : text) c = c == '\n' ? '\r' : c;
  EXPECT_LT(secondsToWalk(text + "x"), 100.0 * seconds);
  EXPECT_LT(secondsToWalk(text + std::string(text.size(), '\r')), 100.0 * seconds);
}

}  // namespace
}  // namespace lavaray
