#pragma once

#include <ctime>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <set>
#include <vector>

#include "watch/folder_events.hpp"

namespace lavaray {

enum class WatchMethod {
  kEvents,   // of the operating system; polling if it has none
  kPolling,  // times and sizes
};

// Tells which files of a set have changed. It watches their folders: a file may be written in place,
// replaced, deleted, or not exist yet, and so may its folder. The target of a symbolic link is watched as
// well.
class FolderWatcher {
 public:
  // Make it before the files are first read, so that no change is lost.
  explicit FolderWatcher(WatchMethod method = WatchMethod::kEvents);

  // Replaces the set of files. No change is lost of a file that was in the set already; nor, of a new one,
  // since changes() last returned something or, before that, since the watcher was made.
  void watch(const std::vector<std::filesystem::path>& files);

  // The files that have changed, once none has changed any further for some 50 ms; or empty. Waits at most
  // `timeout`, not at all if that is 0, or until a signal arrives; files still changing by then are left for
  // another call.
  std::vector<std::filesystem::path> changes(std::chrono::milliseconds timeout);

 private:
  using Clock = std::chrono::steady_clock;

  // What tells versions of a file apart without looking at the content.
  struct FileState {
    int error = 0;  // the system's error number; if not 0, there is no file
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::uint64_t size = 0;
    std::timespec modified{};
    std::timespec changed{};  // a rename or a change of permissions counts, too
    bool operator==(const FileState& other) const;
  };
  static FileState stateOf(const std::filesystem::path& file);

  void watchFolders();
  void mark(std::size_t file);
  void takeEvents();
  void look();
  std::vector<std::filesystem::path> takeMarked();

  WatchMethod method_;
  FolderEvents events_;
  std::vector<std::filesystem::path> files_;
  std::vector<FileState> states_;  // of the files, as last seen
  std::set<std::size_t> marked_;   // which files have changed
  Clock::time_point lastMark_;
  Clock::time_point nextLook_;
  std::timespec since_{};  // the file system's clock when changes() last returned something
};

}  // namespace lavaray
