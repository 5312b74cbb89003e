#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace lavaray {

// A name in a folder, whether there is such a file or not.
struct NameInFolder {
  std::filesystem::path folder;
  std::string name;
  std::size_t number;  // that events about it are told by
};

// What happened to watched names since the last look.
struct FolderChanges {
  std::set<std::size_t> numbers;
  bool foldersMoved = false;  // or deleted: watch() must be called again
  bool everything = false;    // there were too many events to tell
};

// The operating system's events about names in folders (Linux: inotify).
class FolderEvents {
 public:
  FolderEvents();  // where the system refuses, descriptor() is -1 and there are never any events
  ~FolderEvents();
  FolderEvents(const FolderEvents&) = delete;
  FolderEvents& operator=(const FolderEvents&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }  // readable when there are events

  // Replaces what is watched. A folder that is not there, or may not be read, is left out.
  void watch(const std::vector<NameInFolder>& names);
  // Waits for nothing.
  FolderChanges read();

 private:
  int descriptor_;
  std::map<int, std::multimap<std::string, std::size_t>> namesByWatch_;
};

}  // namespace lavaray
