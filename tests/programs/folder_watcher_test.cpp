#include "watch/folder_watcher.hpp"

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

#include "support/input_files.hpp"

namespace lavaray {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;
using Paths = std::vector<std::filesystem::path>;

constexpr milliseconds kEnough{5000};  // for any change to be told
constexpr milliseconds kAWhile{400};   // for one to show that should not

// Longer than a tick of the clock that stamps files.
void letTheClockTick() {
  std::this_thread::sleep_for(milliseconds(20));
}

void replaceByRename(const std::filesystem::path& file, std::string_view content) {
  const std::filesystem::path temporary = file.string() + "~";
  std::ofstream(temporary, std::ios::binary) << content;
  std::filesystem::rename(temporary, file);
}

class FolderWatcherTest : public testing::TestWithParam<WatchMethod> {
 protected:
  FolderWatcherTest() {
    std::filesystem::remove_all(testFolder());
    a_ = writeFile("a", "a");
    b_ = writeFile("b", "b");
    letTheClockTick();
  }

  std::filesystem::path a_;
  std::filesystem::path b_;
};

TEST_P(FolderWatcherTest, NothingChanges) {
  FolderWatcher watcher(GetParam());
  EXPECT_TRUE(watcher.changes(milliseconds(0)).empty());
  watcher.watch({a_, b_});
  const Clock::time_point start = Clock::now();
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
  EXPECT_GE(Clock::now() - start, kAWhile);
  std::ifstream(a_).get();
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
}

TEST_P(FolderWatcherTest, WritingInPlace) {
  FolderWatcher watcher(GetParam());
  watcher.watch({a_, b_});
  writeFile("a", "A");  // of the same size
  EXPECT_EQ(watcher.changes(kEnough), Paths{a_});
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
  std::ofstream(b_, std::ios::app) << "more";
  writeFile("a", "");
  EXPECT_EQ(watcher.changes(kEnough), (Paths{a_, b_}));
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
}

TEST_P(FolderWatcherTest, RenamingOverTheFile) {
  FolderWatcher watcher(GetParam());
  watcher.watch({a_, b_});
  for (int i = 0; i < 3; ++i) {
    replaceByRename(a_, "A");
    EXPECT_EQ(watcher.changes(kEnough), Paths{a_});
    EXPECT_TRUE(watcher.changes(kAWhile).empty());
  }
  // A backup is kept under another name, as editors do.
  std::filesystem::rename(b_, b_.string() + ".bak");
  writeFile("b", "B");
  EXPECT_EQ(watcher.changes(kEnough), Paths{b_});
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
}

TEST_P(FolderWatcherTest, DeletingAndMakingAnew) {
  FolderWatcher watcher(GetParam());
  watcher.watch({a_, b_});
  std::filesystem::remove(a_);
  EXPECT_EQ(watcher.changes(kEnough), Paths{a_});
  writeFile("a", "a");
  EXPECT_EQ(watcher.changes(kEnough), Paths{a_});
  writeFile("a", "A");
  EXPECT_EQ(watcher.changes(kEnough), Paths{a_});
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
}

TEST_P(FolderWatcherTest, FilesAndFoldersThatAreNotThereYet) {
  const auto later = testFolder() / "later";
  const auto inside = testFolder() / "folder/deep/file";
  FolderWatcher watcher(GetParam());
  watcher.watch({later, inside});
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
  writeFile("later", "");
  EXPECT_EQ(watcher.changes(kEnough), Paths{later});
  std::filesystem::create_directories(inside.parent_path());
  writeFile("folder/deep/file", "");
  EXPECT_EQ(watcher.changes(kEnough), Paths{inside});
  writeFile("folder/deep/file", "more");
  EXPECT_EQ(watcher.changes(kEnough), Paths{inside});
}

TEST_P(FolderWatcherTest, OtherFilesAreNotTold) {
  FolderWatcher watcher(GetParam());
  watcher.watch({a_});
  writeFile("b", "B");
  writeFile("a2", "");
  replaceByRename(testFolder() / "picture.bmp", "");
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
  // And do not keep it from being quiet.
  writeFile("a", "A");
  Paths told;
  for (int i = 0; i < 50 && told.empty(); ++i) {
    writeFile("b", std::to_string(i));
    told = watcher.changes(milliseconds(20));
  }
  EXPECT_EQ(told, Paths{a_});
}

// Writes the file 20 times in some 40 ms. Returns the longest time between two writes, which a busy machine
// makes long.
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

TEST_P(FolderWatcherTest, ABurstIsToldOnce) {
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

TEST_P(FolderWatcherTest, WaitsForQuiet) {
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
  // A machine that sleeps in between makes it quiet.
  EXPECT_LE(told, 1);
  if (told == 0) {
    EXPECT_EQ(watcher.changes(kEnough), Paths{a_});
  }
}

TEST_P(FolderWatcherTest, LookingWithoutWaiting) {
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

TEST_P(FolderWatcherTest, AFolderIsReplaced) {
  const auto folder = testFolder() / "folder";
  std::filesystem::create_directory(folder);
  std::filesystem::create_directory(testFolder() / "other");
  const auto file = writeFile("folder/file", "one");
  writeFile("other/file", "two");
  letTheClockTick();
  FolderWatcher watcher(GetParam());
  watcher.watch({file});
  std::filesystem::rename(folder, testFolder() / "old");
  std::filesystem::rename(testFolder() / "other", folder);
  EXPECT_EQ(watcher.changes(kEnough), Paths{file});
  writeFile("old/file", "not watched any more");
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
  writeFile("folder/file", "three");
  EXPECT_EQ(watcher.changes(kEnough), Paths{file});

  std::filesystem::remove_all(folder);
  EXPECT_EQ(watcher.changes(kEnough), Paths{file});
  std::filesystem::create_directory(folder);
  writeFile("folder/file", "four");
  EXPECT_EQ(watcher.changes(kEnough), Paths{file});
}

TEST_P(FolderWatcherTest, SymbolicLinks) {
  std::filesystem::create_directories(testFolder() / "elsewhere/deep");
  const auto target = writeFile("elsewhere/deep/target", "1");
  const auto other = writeFile("elsewhere/other", "2");
  const auto link = testFolder() / "link";
  const auto linkToLink = testFolder() / "elsewhere/link";
  std::filesystem::create_symlink("deep/target", linkToLink);
  std::filesystem::create_symlink("elsewhere/link", link);
  const auto linkToFolder = testFolder() / "folder";
  std::filesystem::create_directory_symlink("elsewhere/deep", linkToFolder);
  letTheClockTick();
  FolderWatcher watcher(GetParam());
  watcher.watch({link, linkToFolder / "target"});
  writeFile("elsewhere/deep/target", "11");
  EXPECT_EQ(watcher.changes(kEnough), (Paths{link, linkToFolder / "target"}));
  replaceByRename(target, "111");
  EXPECT_EQ(watcher.changes(kEnough), (Paths{link, linkToFolder / "target"}));
  std::filesystem::remove(linkToLink);
  std::filesystem::create_symlink("other", linkToLink);
  EXPECT_EQ(watcher.changes(kEnough), Paths{link});
  writeFile("elsewhere/other", "22");
  EXPECT_EQ(watcher.changes(kEnough), Paths{link});
  std::filesystem::remove(linkToFolder);
  std::filesystem::create_directory_symlink("elsewhere", linkToFolder);
  writeFile("elsewhere/target", "another");
  EXPECT_EQ(watcher.changes(kEnough), Paths{linkToFolder / "target"});
  // Links without end are no file.
  std::filesystem::remove(link);
  std::filesystem::create_symlink("link", link);
  EXPECT_EQ(watcher.changes(kEnough), Paths{link});
}

TEST_P(FolderWatcherTest, NoChangeIsLostBetweenTwoSets) {
  FolderWatcher watcher(GetParam());
  watcher.watch({a_});
  writeFile("a", "A");
  watcher.watch({b_, a_});
  EXPECT_EQ(watcher.changes(kEnough), Paths{a_});
  // While the files are read that a change has made necessary, another one gets known.
  const auto c = writeFile("c", "c");
  watcher.watch({a_, b_, c});
  EXPECT_EQ(watcher.changes(kEnough), Paths{c});
  watcher.watch({b_});
  writeFile("a", "AA");
  EXPECT_TRUE(watcher.changes(kAWhile).empty());
}

void onSignal(int /*signal*/) {}

TEST_P(FolderWatcherTest, ASignalEndsTheWaiting) {
  struct sigaction action {};
  struct sigaction before {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;
  sigaction(SIGUSR1, &action, &before);
  FolderWatcher watcher(GetParam());
  watcher.watch({a_});
  const pthread_t waiting = pthread_self();
  const Clock::time_point start = Clock::now();
  // More than one, as it may arrive between two waits.
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

INSTANTIATE_TEST_SUITE_P(Method, FolderWatcherTest,
                         testing::Values(WatchMethod::kEvents, WatchMethod::kPolling),
                         [](const auto& method) {
                           return method.param == WatchMethod::kEvents ? "Events" : "Polling";
                         });

}  // namespace
}  // namespace lavaray
