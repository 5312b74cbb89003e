#include "base/text_blocks.hpp"

#include <algorithm>
#include <string_view>

namespace lavaray {
namespace {

// The end of the last line in [from, text.size()) that is not continued in the next; 0 if there is none.
std::size_t lastLineEnd(std::string_view text, std::size_t from) {
  for (std::size_t end = text.size();;) {
    const std::size_t lf = text.substr(0, end).rfind('\n');
    if (lf == std::string_view::npos || lf < from) return 0;
    const std::size_t last = text.substr(0, lf).find_last_not_of('\r');
    if (last == std::string_view::npos || text[last] != '\\') return lf + 1;
    end = lf;
  }
}

}  // namespace

std::optional<TextBlocks::Block> TextBlocks::next(std::vector<char>& buffer) {
  const std::scoped_lock lock(mutex_);
  const std::size_t size = fill(buffer);
  if (size == 0) return std::nullopt;
  return Block{count_++, std::span(buffer).first(size)};
}

bool TextBlocks::isAtEnd() const {
  const std::scoped_lock lock(mutex_);
  return sourceEnded_ && rest_.empty();
}

// Returns the size of the block. The buffer may be larger: it keeps its size for the next block.
std::size_t TextBlocks::fill(std::vector<char>& buffer) {
  std::size_t length = rest_.size();
  if (buffer.size() < length + bytes_ + 1) buffer.resize(length + bytes_ + 1);
  std::ranges::copy(rest_, buffer.begin());
  rest_.clear();
  std::size_t end = 0;
  for (std::size_t wanted = bytes_; !sourceEnded_ && end == 0; wanted = length) {
    if (buffer.size() < length + wanted + 1) buffer.resize(length + wanted + 1);
    sourceEnded_ = true;  // unless the source proves otherwise; so it stays set if the source throws
    const std::size_t count = read_(std::span(buffer).subspan(length, wanted));
    sourceEnded_ = count < wanted;
    end = lastLineEnd({buffer.data(), length + count}, length);
    // Anything with a NUL byte is not text, and its lines may never end.
    const bool isText = std::string_view(buffer.data() + length, count).find('\0') == std::string_view::npos;
    length += count;
    if (end == 0 && !isText) end = length;
  }
  if (sourceEnded_) {
    if (length > 0 && buffer[length - 1] != '\n') buffer[length++] = '\n';
    return length;
  }
  rest_.assign(buffer.begin() + static_cast<std::ptrdiff_t>(end),
               buffer.begin() + static_cast<std::ptrdiff_t>(length));
  return end;
}

}  // namespace lavaray
