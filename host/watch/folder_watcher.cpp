#include "watch/folder_watcher.hpp"

#include <poll.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace lavaray {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kQuiet{50};
constexpr milliseconds kPollingPeriod{100};
// Besides the events: network file systems send none for what other machines do, and there are none for a
// symbolic link among the folders of a path.
constexpr milliseconds kPeriodBesideEvents{1000};
constexpr milliseconds kMaxWait{std::chrono::hours(24)};

// The system itself follows no more than these.
constexpr int kMaxLinks = 40;

bool isBefore(const std::timespec& a, const std::timespec& b) {
  return std::pair(a.tv_sec, a.tv_nsec) < std::pair(b.tv_sec, b.tv_nsec);
}

// The time that the file system would give a file that changes now.
std::timespec fileTime() {
  std::timespec time{};
  clock_gettime(CLOCK_REALTIME_COARSE, &time);
  return time;
}

std::filesystem::path folderOf(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

// The names whose change may be a change of the file: its own and, if that is a link, its target's, and so
// on.
void addNames(std::filesystem::path file, std::size_t number, std::vector<NameInFolder>& names) {
  for (int links = 0; links <= kMaxLinks; ++links) {
    names.push_back({folderOf(file), file.filename(), number});
    std::error_code noLink;
    const std::filesystem::path target = std::filesystem::read_symlink(file, noLink);
    if (noLink) return;
    file = folderOf(file) / target;
  }
}

}  // namespace

bool FolderWatcher::FileState::operator==(const FileState& other) const {
  const auto same = [](const std::timespec& a, const std::timespec& b) {
    return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
  };
  return error == other.error && device == other.device && inode == other.inode && size == other.size &&
         same(modified, other.modified) && same(changed, other.changed);
}

FolderWatcher::FileState FolderWatcher::stateOf(const std::filesystem::path& file) {
  struct stat status {};
  FileState state;
  if (stat(file.c_str(), &status) != 0) {
    state.error = errno;
    return state;
  }
  state.device = status.st_dev;
  state.inode = status.st_ino;
  state.size = static_cast<std::uint64_t>(status.st_size);
  state.modified = status.st_mtim;
  state.changed = status.st_ctim;
  return state;
}

FolderWatcher::FolderWatcher(WatchMethod method)
    : method_(method), nextLook_(Clock::now()), since_(fileTime()) {
  if (events_.descriptor() < 0) method_ = WatchMethod::kPolling;
}

void FolderWatcher::watch(const std::vector<std::filesystem::path>& files) {
  takeEvents();  // while their numbers still mean the old files
  const std::vector<std::filesystem::path> oldFiles = std::exchange(files_, {});
  const std::vector<FileState> oldStates = std::exchange(states_, {});
  const std::set<std::size_t> oldMarked = std::exchange(marked_, {});
  for (const std::filesystem::path& file : files) {
    if (std::ranges::find(files_, file) == files_.end()) files_.push_back(file);
  }
  watchFolders();  // before the look at the files, so that nothing falls between
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const auto old = static_cast<std::size_t>(std::ranges::find(oldFiles, files_[i]) - oldFiles.begin());
    const bool isOld = old < oldFiles.size();
    states_.push_back(isOld ? oldStates[old] : stateOf(files_[i]));
    if (isOld ? oldMarked.contains(old) : states_[i].error == 0 && !isBefore(states_[i].changed, since_))
      mark(i);
  }
  nextLook_ = Clock::now();
}

std::vector<std::filesystem::path> FolderWatcher::changes(milliseconds timeout) {
  const Clock::time_point deadline = Clock::now() + std::min(timeout, kMaxWait);
  for (;;) {
    takeEvents();
    const auto isQuiet = [&] { return !marked_.empty() && Clock::now() - lastMark_ >= kQuiet; };
    if (Clock::now() >= nextLook_ || isQuiet()) look();
    if (isQuiet()) return takeMarked();

    const Clock::time_point now = Clock::now();
    if (now >= deadline) return {};
    Clock::time_point wake = std::min(deadline, nextLook_);
    if (!marked_.empty()) wake = std::min(wake, lastMark_ + kQuiet);
    pollfd descriptor{method_ == WatchMethod::kEvents ? events_.descriptor() : -1, POLLIN, 0};
    const auto wait = std::max(std::chrono::ceil<milliseconds>(wake - now), milliseconds(1));
    if (poll(&descriptor, 1, static_cast<int>(wait.count())) < 0) return {};
  }
}

void FolderWatcher::watchFolders() {
  if (method_ == WatchMethod::kPolling) return;
  std::vector<NameInFolder> names;
  for (std::size_t i = 0; i < files_.size(); ++i) addNames(files_[i], i, names);
  events_.watch(names);
}

void FolderWatcher::mark(std::size_t file) {
  marked_.insert(file);
  lastMark_ = Clock::now();
}

void FolderWatcher::takeEvents() {
  const FolderChanges changes = events_.read();
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (!changes.everything && !changes.numbers.contains(i)) continue;
    states_[i] = stateOf(files_[i]);
    mark(i);
  }
  if (changes.everything || changes.foldersMoved) look();
}

// Looks for changes of which there was no event.
void FolderWatcher::look() {
  watchFolders();
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const FileState state = stateOf(files_[i]);
    if (state == states_[i]) continue;
    states_[i] = state;
    mark(i);
  }
  nextLook_ = Clock::now() + (method_ == WatchMethod::kPolling ? kPollingPeriod : kPeriodBesideEvents);
}

std::vector<std::filesystem::path> FolderWatcher::takeMarked() {
  std::vector<std::filesystem::path> result;
  for (const std::size_t file : std::exchange(marked_, {})) result.push_back(files_[file]);
  since_ = fileTime();
  return result;
}

}  // namespace lavaray
