#include "base/temporary_file.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string_view>
#include <system_error>

namespace lavaray {
namespace fs = std::filesystem;
namespace {

// Tells a temporary name from any other.
constexpr std::string_view kMark = ".lavaray-";
constexpr std::size_t kRandomLetters = 6;

// Stored where a signal handler can read them; more than the program ever writes at a time.
std::array<std::atomic<const char*>, 16> temporaries{};
static_assert(std::atomic<const char*>::is_always_lock_free, "a signal handler may read it");
std::atomic<pid_t> owner{0};

void replaceTemporary(const char* before, const char* after) {
  owner = getpid();
  for (std::atomic<const char*>& temporary : temporaries) {
    const char* expected = before;
    if (temporary.compare_exchange_strong(expected, after)) return;
  }
}

[[noreturn]] void fail() {
  throw std::system_error(errno, std::generic_category());
}

std::string randomLetters() {
  constexpr std::string_view kLetters = "0123456789abcdefghijklmnopqrstuvwxyz";
  std::array<std::uint8_t, kRandomLetters> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) fail();
  std::string letters;
  for (const std::uint8_t byte : bytes) letters += kLetters[byte % kLetters.size()];
  return letters;
}

// False if another process holds the lock, or if the file system has no locks: then nothing is known. The
// lock lasts as long as the descriptor is open.
bool lock(int descriptor) {
  return flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

// Like open(2), for writing by this process alone.
int openNew(const fs::path& path, int flags) {
  return open(path.c_str(), flags | O_RDWR | O_CLOEXEC, 0666);
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& target)
    : target_(target), folder_(target.has_parent_path() ? target.parent_path() : fs::path(".")) {
  const std::string name = target.filename().string();
  prefix_ = "." + name.substr(0, NAME_MAX - 1 - kMark.size() - kRandomLetters) + std::string(kMark);
  removeLeftovers();
  if (!openUnnamed()) openNamed();
}

TemporaryFile::~TemporaryFile() {
  if (!name_.empty()) {
    unlink(name_.c_str());
    forgetName();
  }
  close(descriptor_);
}

// Whether it made a file without a name. Makes and names another one first, so that naming does not turn out
// to be impossible at the end. (A file whose name was removed cannot be given a new one.)
bool TemporaryFile::openUnnamed() {
  descriptor_ = openNew(folder_, O_TMPFILE);
  if (descriptor_ < 0) return false;
  const bool isNamed = link();
  if (isNamed) {
    unlink(name_.c_str());
    forgetName();
  }
  close(descriptor_);
  descriptor_ = isNamed ? openNew(folder_, O_TMPFILE) : -1;
  return descriptor_ >= 0;
}

void TemporaryFile::openNamed() {
  for (;;) {
    setName(newName());  // before the file exists, so that no signal can come in between
    descriptor_ = openNew(name_, O_CREAT | O_EXCL);
    const int reason = errno;
    struct stat status {};
    // Another process may have removed it as a leftover before it was locked.
    if (descriptor_ >= 0 && (lock(descriptor_) || errno != EWOULDBLOCK) && fstat(descriptor_, &status) == 0 &&
        status.st_nlink > 0)
      return;
    if (descriptor_ >= 0) close(descriptor_);
    forgetName();
    errno = reason;
    if (descriptor_ < 0 && reason != EEXIST) fail();
  }
}

void TemporaryFile::giveName() {
  if (name_.empty() && !link()) fail();
}

bool TemporaryFile::link() {
  lock(descriptor_);
  const std::string self = "/proc/self/fd/" + std::to_string(descriptor_);
  do {
    setName(newName());
    if (linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name_.c_str(), AT_SYMLINK_FOLLOW) == 0) return true;
    const int reason = errno;
    forgetName();
    errno = reason;
  } while (errno == EEXIST);
  return false;
}

bool TemporaryFile::replaceTarget() {
  if (std::rename(name_.c_str(), target_.c_str()) != 0) return false;
  forgetName();
  return true;
}

fs::path TemporaryFile::keep() {
  const std::string letters = "-" + randomLetters();
  std::string extension = target_.extension().string();
  if (letters.size() + extension.size() >= NAME_MAX) extension.clear();
  const std::string stem = target_.stem().string().substr(0, NAME_MAX - letters.size() - extension.size());
  const std::string visible = stem + letters + extension;
  fs::path kept = folder_ / visible;
  if (std::rename(name_.c_str(), kept.c_str()) != 0) kept = name_;
  forgetName();
  return kept;
}

std::string TemporaryFile::newName() const {
  return (folder_ / (prefix_ + randomLetters())).string();
}

void TemporaryFile::setName(const std::string& name) {
  name_ = name;
  replaceTemporary(nullptr, name_.c_str());
}

void TemporaryFile::forgetName() {
  replaceTemporary(name_.c_str(), nullptr);
  name_.clear();
}

// Removes what killed processes have left behind. Goes wrong only if two machines write the same file at
// once, in a folder that they share without sharing its locks.
void TemporaryFile::removeLeftovers() const {
  const std::unique_ptr<DIR, int (*)(DIR*)> folder(opendir(folder_.c_str()), closedir);
  if (!folder) return;
  while (const dirent* entry = readdir(folder.get())) {
    const std::string_view name = entry->d_name;
    if (name.size() != prefix_.size() + kRandomLetters || !name.starts_with(prefix_)) continue;
    const int descriptor =
        openat(dirfd(folder.get()), entry->d_name, O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) continue;
    struct stat status {};
    if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && lock(descriptor))
      unlinkat(dirfd(folder.get()), entry->d_name, 0);
    close(descriptor);
  }
}

void removeTemporaryFiles() {
  if (owner != getpid()) return;
  for (const std::atomic<const char*>& temporary : temporaries) {
    if (const char* name = temporary) unlink(name);
  }
}

}  // namespace lavaray
