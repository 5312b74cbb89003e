#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace lavaray {

inline unsigned hardwareThreads() {
  return std::max(1U, std::thread::hardware_concurrency());
}

// Calls work(i) for each i in [0, count) on up to `threads` threads, including the caller's, and returns when
// all calls are done. `work` must not throw, and its calls must not depend on one another.
template <typename Work>
void parallelFor(std::size_t count, unsigned threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto loop = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> helpers;
  try {
    for (std::size_t t = 1; t < std::min<std::size_t>(threads, count); ++t) helpers.emplace_back(loop);
  } catch (const std::system_error&) {
    // A limit on threads or memory: the threads that were started do the work.
  }
  loop();
}

}  // namespace lavaray
