#include "watch/folder_events.hpp"

#include <sys/resource.h>

#include <chrono>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "support/input_files.hpp"
#include "watch/folder_watcher.hpp"

namespace lavaray {
namespace {

using std::chrono::milliseconds;
using Paths = std::vector<std::filesystem::path>;

constexpr milliseconds kEnough{5000};

// Longer than a tick of the clock that stamps files.
void letTheClockTick() {
  std::this_thread::sleep_for(milliseconds(20));
}

TEST(FolderEvents, TooManyOfThemMeanEverything) {
  const auto a = writeFile("a", "");
  const auto b = writeFile("b", "");
  letTheClockTick();
  FolderEvents events;
  ASSERT_GE(events.descriptor(), 0);
  events.watch({{testFolder(), "a", 0}});
  FolderWatcher watcher;
  watcher.watch({a, b});
  int limit = 0;
  std::ifstream("/proc/sys/fs/inotify/max_queued_events") >> limit;
  if (limit <= 0 || limit > 100000) GTEST_SKIP() << "a queue that cannot be filled: " << limit;
  const auto x = writeFile("x", "");
  for (int i = 0; i < limit; ++i) {
    std::filesystem::rename(x, testFolder() / "y");
    std::filesystem::rename(testFolder() / "y", x);
  }
  EXPECT_TRUE(events.read().everything);
  EXPECT_FALSE(events.read().everything);
  EXPECT_EQ(watcher.changes(kEnough), (Paths{a, b}));
  EXPECT_TRUE(watcher.changes(milliseconds(200)).empty());
}

TEST(FolderEvents, NamesOfOneFolderByTwoPaths) {
  std::filesystem::create_directory_symlink(".", testFolder() / "here");
  FolderEvents events;
  events.watch({{testFolder(), "a", 5}, {testFolder() / "here", "a", 6}, {testFolder() / "here", "b", 7}});
  writeFile("a", "");
  EXPECT_EQ(events.read().numbers, (std::set<std::size_t>{5, 6}));
  writeFile("b", "");
  writeFile("c", "");
  EXPECT_EQ(events.read().numbers, (std::set<std::size_t>{7}));
  events.watch({{testFolder(), "c", 0}});
  writeFile("b", "");
  EXPECT_TRUE(events.read().numbers.empty());
  EXPECT_FALSE(events.read().foldersMoved);
}

TEST(FolderEvents, PollingWhereThereAreNone) {
  const auto file = writeFile("file", "");
  letTheClockTick();
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none{3, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  const FolderEvents events;
  FolderWatcher watcher;
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_LT(events.descriptor(), 0);
  watcher.watch({file});
  writeFile("file", "x");
  EXPECT_EQ(watcher.changes(kEnough), Paths{file});
}

}  // namespace
}  // namespace lavaray
