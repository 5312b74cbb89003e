#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>

namespace lavaray {

// Asks the system to back untouched memory with huge pages. Every small page costs a fault when it is first
// touched: for an image's pixels that takes as long as tracing them if the scene is simple. The system may
// refuse.
inline void preferHugePages(void* memory, std::size_t bytes) {
  constexpr std::uintptr_t kHugePage = std::uintptr_t{1} << 21U;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + kHugePage - 1) / kHugePage * kHugePage;
  const std::uintptr_t end = (begin + bytes) / kHugePage * kHugePage;
  if (first < end) (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

}  // namespace lavaray
