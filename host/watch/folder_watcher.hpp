#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <vector>

namespace lavaray {

// Notices that files change, by looking at their times and sizes.
class FolderWatcher {
 public:
  // Replaces the set of files of interest. They need not exist yet.
  void watch(const std::vector<std::filesystem::path>& files);

  // Files of the set that changed since the last call, once nothing more happens to them; empty where none
  // did. Waits for at most `timeout`; 0 only looks.
  std::vector<std::filesystem::path> changes(std::chrono::milliseconds timeout);

 private:
  struct State {
    std::filesystem::file_time_type time;
    std::uintmax_t size;
    bool operator==(const State&) const = default;
  };
  static State stateOf(const std::filesystem::path& file);

  std::map<std::filesystem::path, State> files_;
};

}  // namespace lavaray
