#pragma once

#include <lavaray/error.h>

namespace lavaray {

// Throws what is being caught as an error of the public interface.
[[noreturn]] void throwPublicError();

// What `work` returns. Every public function whose work may fail does it in here.
template <typename Work>
auto guarded(const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (...) {
    throwPublicError();
  }
}

}  // namespace lavaray
