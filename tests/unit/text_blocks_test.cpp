#include "base/text_blocks.hpp"

#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "base/parallel.hpp"

namespace lavaray {
namespace {

ReadBytes sourceOf(std::string_view text) {
  return [text](std::span<char> bytes) mutable {
    const std::size_t count = text.copy(bytes.data(), bytes.size());
    text.remove_prefix(count);
    return count;
  };
}

using Blocks = std::vector<std::string>;

Blocks blocksOf(std::string_view text, std::size_t bytes) {
  TextBlocks blocks(sourceOf(text), bytes);
  Blocks result;
  std::vector<char> buffer;
  while (const auto block = blocks.next(buffer)) {
    EXPECT_EQ(block->number, result.size());
    result.emplace_back(block->text.begin(), block->text.end());
  }
  EXPECT_TRUE(blocks.isAtEnd());
  return result;
}

TEST(TextBlocks, EndWhereALineEndsThatDoesNotGoOn) {
  EXPECT_EQ(blocksOf("", 4), Blocks{});
  EXPECT_EQ(blocksOf("a", 4), Blocks{"a\n"});
  EXPECT_EQ(blocksOf("a\nb\nc\nd", 4), (Blocks{"a\nb\n", "c\nd\n"}));
  EXPECT_EQ(blocksOf("a\nb\ncc\nd\n", 5), (Blocks{"a\nb\n", "cc\nd\n"}));
  EXPECT_EQ(blocksOf("a\nb\\\nc\nd\n", 5), (Blocks{"a\n", "b\\\nc\nd\n"}));
  EXPECT_EQ(blocksOf("\\\n\\\r\n\\\r\r\nd\ne\n", 12), (Blocks{"\\\n\\\r\n\\\r\r\nd\n", "e\n"}));
  EXPECT_EQ(blocksOf("a\\\n", 1), Blocks{"a\\\n"});
}

TEST(TextBlocks, AreTheTextWhateverTheirSize) {
  const std::string text = "v 1 \\\n2 3\r\n\r\n#\\\r\rlong line\n\\\n\n\n\nf 1 2 3\\\\\nlast";
  for (std::size_t bytes = 1; bytes <= text.size() + 1; ++bytes) {
    std::string joined;
    for (const std::string& block : blocksOf(text, bytes)) joined += block;
    EXPECT_EQ(joined, text + '\n') << bytes;
  }
}

TEST(TextBlocks, GoToSeveralThreads) {
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += std::to_string(i) + '\n';
  TextBlocks blocks(sourceOf(text), 64);
  std::vector<std::string> found;
  std::mutex mutex;
  parallelFor(4, 4, [&](std::size_t) {
    std::vector<char> buffer;
    while (const auto block = blocks.next(buffer)) {
      const std::scoped_lock lock(mutex);
      if (found.size() <= block->number) found.resize(block->number + 1);
      found[block->number].assign(block->text.begin(), block->text.end());
    }
  });
  std::string joined;
  for (const std::string& block : found) joined += block;
  EXPECT_EQ(joined, text);
}

TEST(TextBlocks, EndWithWhatTheSourceThrows) {
  int reads = 0;
  TextBlocks blocks(
      [&](std::span<char> bytes) -> std::size_t {
        if (++reads == 2) throw std::runtime_error("no more");
        bytes[0] = '\n';
        return bytes.size();
      },
      1);
  std::vector<char> buffer;
  EXPECT_TRUE(blocks.next(buffer));
  EXPECT_THROW((void)blocks.next(buffer), std::runtime_error);
  EXPECT_FALSE(blocks.next(buffer));
  EXPECT_EQ(reads, 2);
}

}  // namespace
}  // namespace lavaray
