#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>

namespace lavaray {

// Asks the system for huge pages for memory that nobody has touched yet. A first touch of each small page is
// a fault: for the pixels of a picture they take as long as tracing it, where the scene is simple. A wish,
// which may be refused.
inline void preferHugePages(void* memory, std::size_t bytes) {
  constexpr std::uintptr_t kHugePage = std::uintptr_t{1} << 21U;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + kHugePage - 1) / kHugePage * kHugePage;
  const std::uintptr_t end = (begin + bytes) / kHugePage * kHugePage;
  if (first < end) (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

}  // namespace lavaray
