// Which changes a watcher reports.
#include "watch/folder_watcher.hpp"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "programs/watched_files.hpp"

namespace lavaray {
namespace {

using std::chrono::milliseconds;

void replaceByRename(const std::filesystem::path& file, std::string_view content) {
  const std::filesystem::path temporary = file.string() + "~";
  std::ofstream(temporary, std::ios::binary) << content;
  std::filesystem::rename(temporary, file);
}

class FolderWatcherTest : public WatchedFiles {};

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
  // As editors do that keep a backup under another name.
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
  // Nor do they delay the report of a watched file.
  writeFile("a", "A");
  Paths told;
  for (int i = 0; i < 50 && told.empty(); ++i) {
    writeFile("b", std::to_string(i));
    told = watcher.changes(milliseconds(20));
  }
  EXPECT_EQ(told, Paths{a_});
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
  // A link to itself is no file.
  std::filesystem::remove(link);
  std::filesystem::create_symlink("link", link);
  EXPECT_EQ(watcher.changes(kEnough), Paths{link});
}

INSTANTIATE_TEST_SUITE_P(Method, FolderWatcherTest, kWatchMethods, watchMethodName);

}  // namespace
}  // namespace lavaray
