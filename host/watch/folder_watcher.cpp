#include "watch/folder_watcher.hpp"

#include <thread>

namespace lavaray {

void FolderWatcher::watch(const std::vector<std::filesystem::path>& files) {
  std::map<std::filesystem::path, State> states;
  for (const auto& file : files) {
    const auto known = files_.find(file);
    states[file] = known != files_.end() ? known->second : stateOf(file);
  }
  files_ = std::move(states);
}

std::vector<std::filesystem::path> FolderWatcher::changes(std::chrono::milliseconds timeout) {
  std::this_thread::sleep_for(timeout);
  std::vector<std::filesystem::path> changed;
  for (auto& [file, state] : files_) {
    const State now = stateOf(file);
    if (now == state) continue;
    state = now;
    changed.push_back(file);
  }
  return changed;
}

FolderWatcher::State FolderWatcher::stateOf(const std::filesystem::path& file) {
  std::error_code missing;
  return {std::filesystem::last_write_time(file, missing), std::filesystem::file_size(file, missing)};
}

}  // namespace lavaray
