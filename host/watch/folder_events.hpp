#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace lavaray {

// A name in a folder, whether or not there is such a file.
struct NameInFolder {
  std::filesystem::path folder;
  std::string name;
  std::size_t number;  // by which changes are reported
};

// What has happened to watched names since the last read().
struct FolderChanges {
  std::set<std::size_t> numbers;
  bool foldersMoved = false;  // or were deleted: watch() must be called again
  bool everything = false;    // perhaps: there were too many events to tell
};

// The operating system's events about names in folders (Linux: inotify).
class FolderEvents {
 public:
  FolderEvents();  // if the system refuses, descriptor() is -1 and there are never any events
  ~FolderEvents();
  FolderEvents(const FolderEvents&) = delete;
  FolderEvents& operator=(const FolderEvents&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }  // readable when there are events

  // Replaces what is watched. Leaves out folders that do not exist or may not be read.
  void watch(const std::vector<NameInFolder>& names);
  // Does not wait.
  FolderChanges read();

 private:
  int descriptor_;
  std::map<int, std::multimap<std::string, std::size_t>> namesByWatch_;
};

}  // namespace lavaray
