#pragma once

#include <cstdint>

namespace lavaray {

// Samples first <= i < end of each pixel's sequence.
struct SampleRange {
  std::uint32_t first;
  std::uint32_t end;
  bool operator==(const SampleRange&) const = default;
};

}  // namespace lavaray
