// When a watcher reports changes, and how long it waits for them.
#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <future>
#include <string>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include "programs/watched_files.hpp"
#include "watch/folder_watcher.hpp"

namespace lavaray {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

class FolderWatcherTiming : public WatchedFiles {};

TEST_P(FolderWatcherTiming, NothingChanges) {
  FolderWatcher watcher(GetParam());
  EXPECT_TRUE(watcher.changes(milliseconds(0)).empty());
  watcher.watch({a_, b_});
  const Clock::time_point start = Clock::now();
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
  EXPECT_GE(Clock::now() - start, kAWhile);
  std::ifstream(a_).get();
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
}

// Writes the file 20 times in some 40 ms. Returns the longest gap between two writes, which grows on a busy
// machine.
Clock::duration writeBurst() {
  Clock::duration longest{};
  Clock::time_point last = Clock::now();
  for (int i = 0; i < 20; ++i) {
    writeFile("a", std::to_string(i));
    const Clock::time_point now = Clock::now();
    longest = std::max(longest, now - std::exchange(last, now));
    std::this_thread::sleep_for(milliseconds(2));
  }
  return longest;
}

TEST_P(FolderWatcherTiming, ABurstIsToldOnce) {
  FolderWatcher watcher(GetParam());
  watcher.watch({a_, b_});
  for (int attempt = 0; attempt < 20; ++attempt) {
    auto longest = std::async(std::launch::async, writeBurst);
    EXPECT_EQ(watcher.changes(kEnough), Paths{a_});
    const bool isBurst = longest.get() < milliseconds(30);
    const Paths told = watcher.changes(kAWhile);
    if (!isBurst) continue;
    EXPECT_TRUE(told.empty());
    return;
  }
  GTEST_SKIP() << "the machine is too busy for a burst";
}

TEST_P(FolderWatcherTiming, WaitsForQuiet) {
  FolderWatcher watcher(GetParam());
  watcher.watch({a_});
  writeFile("a", "A");
  EXPECT_TRUE(watcher.changes(milliseconds(10)).empty());
  const Clock::time_point end = Clock::now() + milliseconds(500);
  int told = 0;
  while (Clock::now() < end) {
    writeFile("a", "A");
    told += watcher.changes(milliseconds(5)).empty() ? 0 : 1;
  }
  // On a machine that stalls in between, the file seems quiet.
  EXPECT_LE(told, 1);
  if (told == 0) {
    EXPECT_EQ(watcher.changes(kEnough), Paths{a_});
  }
}

TEST_P(FolderWatcherTiming, LookingWithoutWaiting) {
  FolderWatcher watcher(GetParam());
  watcher.watch({a_, b_});
  writeFile("a", "A");
  Paths told;
  Clock::duration shortest = kEnough;
  const Clock::time_point end = Clock::now() + kEnough;
  while (told.empty() && Clock::now() < end) {
    const Clock::time_point start = Clock::now();
    told = watcher.changes(milliseconds(0));
    shortest = std::min(shortest, Clock::now() - start);
    std::this_thread::sleep_for(milliseconds(100));
  }
  EXPECT_EQ(told, Paths{a_});
  EXPECT_LT(shortest, milliseconds(10));
}

TEST_P(FolderWatcherTiming, NoChangeIsLostBetweenTwoSets) {
  FolderWatcher watcher(GetParam());
  watcher.watch({a_});
  writeFile("a", "A");
  watcher.watch({b_, a_});
  EXPECT_EQ(watcher.changes(kEnough), Paths{a_});
  // A change may reveal another file while those it concerns are being read.
  const auto c = writeFile("c", "c");
  watcher.watch({a_, b_, c});
  EXPECT_EQ(watcher.changes(kEnough), Paths{c});
  watcher.watch({b_});
  writeFile("a", "AA");
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
}

void onSignal(int /*signal*/) {}

TEST_P(FolderWatcherTiming, ASignalEndsTheWaiting) {
  struct sigaction action {};
  struct sigaction before {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;
  sigaction(SIGUSR1, &action, &before);
  FolderWatcher watcher(GetParam());
  watcher.watch({a_});
  const pthread_t waiting = pthread_self();
  const Clock::time_point start = Clock::now();
  // Several signals, since one may arrive between two waits.
  std::atomic<bool> isOver{false};
  std::thread sender([&] {
    while (!isOver) {
      std::this_thread::sleep_for(milliseconds(100));
      pthread_kill(waiting, SIGUSR1);
    }
  });
  EXPECT_TRUE(watcher.changes(milliseconds(20000)).empty());
  EXPECT_LT(Clock::now() - start, milliseconds(10000));
  isOver = true;
  sender.join();
  sigaction(SIGUSR1, &before, nullptr);
}

INSTANTIATE_TEST_SUITE_P(Method, FolderWatcherTiming, kWatchMethods, watchMethodName);

}  // namespace
}  // namespace lavaray
