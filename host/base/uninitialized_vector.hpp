#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/huge_pages.hpp"

namespace lavaray {

template <typename T>
struct UninitializedAllocator : std::allocator<T> {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  template <typename U>
  struct rebind {
    using other = UninitializedAllocator<U>;
  };
  T* allocate(std::size_t count) {
    T* const memory = std::allocator<T>::allocate(count);
    preferHugePages(memory, count * sizeof(T));
    return memory;
  }
  void construct(T*) {}
  template <typename... Arguments>
  void construct(T* element, Arguments&&... arguments) {
    std::construct_at(element, std::forward<Arguments>(arguments)...);
  }
};

// A vector whose resize() leaves new elements uninitialised: for large arrays that several threads then fill,
// so that the page faults fall to those threads instead of the caller, and only where something is written.
template <typename T>
using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

}  // namespace lavaray
