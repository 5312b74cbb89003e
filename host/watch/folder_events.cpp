#include "watch/folder_events.hpp"

#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace lavaray {
namespace {

constexpr std::uint32_t kNameEvents =
    IN_MODIFY | IN_CLOSE_WRITE | IN_ATTRIB | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO;
constexpr std::uint32_t kFolderEvents = IN_DELETE_SELF | IN_MOVE_SELF;
// The system sends the latter two unasked.
constexpr std::uint32_t kFolderLost = kFolderEvents | IN_UNMOUNT | IN_IGNORED;

}  // namespace

FolderEvents::FolderEvents() : descriptor_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {}

FolderEvents::~FolderEvents() {
  if (descriptor_ >= 0) close(descriptor_);
}

void FolderEvents::watch(const std::vector<NameInFolder>& names) {
  if (descriptor_ < 0) return;
  std::map<int, std::multimap<std::string, std::size_t>> namesByWatch;
  std::map<std::filesystem::path, int> watches;
  for (const NameInFolder& name : names) {
    const auto [known, isNew] = watches.try_emplace(name.folder, -1);
    // For a folder that is watched already, by whatever path, this returns the same number and loses no
    // event.
    if (isNew) {
      known->second =
          inotify_add_watch(descriptor_, name.folder.c_str(), kNameEvents | kFolderEvents | IN_ONLYDIR);
    }
    if (known->second >= 0) namesByWatch[known->second].emplace(name.name, name.number);
  }
  for (const auto& [watch, unused] : namesByWatch_) {
    if (!namesByWatch.contains(watch)) inotify_rm_watch(descriptor_, watch);
  }
  namesByWatch_ = std::move(namesByWatch);
}

FolderChanges FolderEvents::read() {
  FolderChanges changes;
  alignas(inotify_event) std::array<char, 16384> buffer;
  for (;;) {
    // A signal in between leaves the events in the queue.
    const ssize_t size = descriptor_ < 0 ? -1 : ::read(descriptor_, buffer.data(), buffer.size());
    if (size <= 0) return changes;
    for (std::size_t at = 0; at < static_cast<std::size_t>(size);) {
      inotify_event event;
      std::memcpy(&event, buffer.data() + at, sizeof event);
      const char* name = buffer.data() + at + sizeof event;  // of event.len bytes, padded with zeros
      at += sizeof event + event.len;
      if ((event.mask & IN_Q_OVERFLOW) != 0) changes.everything = true;
      const auto names = namesByWatch_.find(event.wd);
      if (names == namesByWatch_.end()) continue;
      if ((event.mask & kFolderLost) != 0) changes.foldersMoved = true;
      if (event.len == 0) continue;
      const auto [begin, end] = names->second.equal_range(name);
      for (auto found = begin; found != end; ++found) changes.numbers.insert(found->second);
    }
  }
}

}  // namespace lavaray
