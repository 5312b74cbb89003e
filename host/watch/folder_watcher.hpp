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
  kEvents,   // of the operating system's, or polling where it has none
  kPolling,  // of times and sizes
};

// Tells which of some files have changed. It watches the files' folders: a file may be written in place,
// replaced, deleted, or not be there yet, and its folder likewise. Behind a symbolic link the target is
// watched as well.
class FolderWatcher {
 public:
  // To be made before the files are read for the first time, so that no change is lost.
  explicit FolderWatcher(WatchMethod method = WatchMethod::kEvents);

  // Replaces the set of files. Of a file that was in the set before, no change is lost; of another one none
  // since the last time that changes() returned something, or since the watcher was made.
  void watch(const std::vector<std::filesystem::path>& files);

  // The files of the set that have changed, once none has for some 50 ms; empty where none has. Waits at most
  // `timeout` (with 0 it only looks) or until a signal arrives; what is not quiet by then is left for another
  // call.
  std::vector<std::filesystem::path> changes(std::chrono::milliseconds timeout);

 private:
  using Clock = std::chrono::steady_clock;

  // What tells one version of a file from another, whatever its content.
  struct FileState {
    int error = 0;  // the system's number; there is no file then
    std::uint64_t device = 0;
    std::uint64_t number = 0;  // the inode's
    std::uint64_t size = 0;
    std::timespec modified{};
    std::timespec changed{};  // also by a rename or a change of its permissions
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
  std::vector<FileState> states_;  // of the files, when they were looked at last
  std::set<std::size_t> marked_;   // those that have changed
  Clock::time_point lastMark_;
  Clock::time_point nextLook_;
  std::timespec since_{};  // the file system's time when changes() last returned something
};

}  // namespace lavaray
