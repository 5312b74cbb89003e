#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace lavaray {

// Fills the bytes as far as the source goes and returns how many it filled. May throw.
using ReadBytes = std::function<std::size_t(std::span<char>)>;

// Cuts a text into blocks for several threads while it is read, so that it is never in memory as a whole. A
// block ends where a line ends with LF that has no `\` in front of it: a line that goes on in the next one is
// in one block with it. The text's last line gets an LF if it has none.
class TextBlocks {
 public:
  // Blocks have about so many bytes, > 0, more where a line is longer.
  TextBlocks(ReadBytes read, std::size_t bytes) : read_(std::move(read)), bytes_(bytes) {}

  struct Block {
    std::size_t number;    // from 0
    std::span<char> text;  // never empty, ends with LF or has a NUL byte
  };

  // The next block, read into `buffer`; nothing at the end. May be called by several threads. Once it has
  // thrown what the source threw, there are no more blocks.
  std::optional<Block> next(std::vector<char>& buffer);

  // Whether the last block has been returned, or the end is not known yet.
  [[nodiscard]] bool isAtEnd() const;

 private:
  std::size_t fill(std::vector<char>& buffer);

  mutable std::mutex mutex_;
  ReadBytes read_;
  std::size_t bytes_;
  std::vector<char> rest_;  // read, but behind the last block's end
  std::size_t count_ = 0;
  bool sourceEnded_ = false;
};

}  // namespace lavaray
