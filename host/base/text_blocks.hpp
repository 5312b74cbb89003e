#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace lavaray {

// Fills `bytes`, or as many of them as the source has left, and returns how many it filled. May throw.
using ReadBytes = std::function<std::size_t(std::span<char> bytes)>;

// Cuts a text into blocks for several threads as it is read, so that it is never in memory as a whole. A
// block ends at an LF without a `\` before it, so a line is in the same block as its continuation. If the
// text's last line has no LF, it gets one.
class TextBlocks {
 public:
  // Blocks have about `bytes` bytes, > 0, or more if a line is longer.
  TextBlocks(ReadBytes read, std::size_t bytes) : read_(std::move(read)), bytes_(bytes) {}

  struct Block {
    std::size_t number;    // from 0
    std::span<char> text;  // never empty, ends with LF or has a NUL byte
  };

  // The next block, read into `buffer`; empty at the end. Safe to call from several threads. Passes on
  // whatever the source throws; after that there are no more blocks.
  std::optional<Block> next(std::vector<char>& buffer);

  // Whether it is known that the last block has been returned.
  [[nodiscard]] bool isAtEnd() const;

 private:
  std::size_t fill(std::vector<char>& buffer);

  mutable std::mutex mutex_;
  ReadBytes read_;
  std::size_t bytes_;
  std::vector<char> rest_;  // read already, but beyond the last block's end
  std::size_t count_ = 0;
  bool sourceEnded_ = false;
};

}  // namespace lavaray
