#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "support/input_files.hpp"
#include "watch/folder_watcher.hpp"

namespace lavaray {

using Paths = std::vector<std::filesystem::path>;

inline constexpr std::chrono::milliseconds kEnough{5000};  // for any change to be reported
inline constexpr std::chrono::milliseconds kAWhile{400};   // for a report to turn up that should not

// Longer than a tick of the clock that time-stamps files.
inline void letTheClockTick() {
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

// Two files to watch, by either method.
class WatchedFiles : public testing::TestWithParam<WatchMethod> {
 protected:
  WatchedFiles() {
    std::filesystem::remove_all(testFolder());
    a_ = writeFile("a", "a");
    b_ = writeFile("b", "b");
    letTheClockTick();
  }

  std::filesystem::path a_;
  std::filesystem::path b_;
};

inline const auto kWatchMethods = testing::Values(WatchMethod::kEvents, WatchMethod::kPolling);

inline std::string watchMethodName(const testing::TestParamInfo<WatchMethod>& method) {
  return method.param == WatchMethod::kEvents ? "Events" : "Polling";
}

}  // namespace lavaray
