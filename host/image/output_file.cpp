#include "image/output_file.hpp"

#include <fcntl.h>
#include <stdio_ext.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "core/errors.hpp"
#include "core/place.hpp"

namespace lavaray {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
  throw Error(ExitCode::kOutput, printable(path.native()) + ": cannot be written: " + why);
}

// The mode that a file made by open(2) would have; the one of mkstemp is private to its owner.
mode_t ordinaryMode() {
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

// Names of the files that are being written, where a signal handler can read them; more than a program ever
// writes at a time.
std::array<std::atomic<const char*>, 16> temporaries{};
static_assert(std::atomic<const char*>::is_always_lock_free, "a signal handler may read it");

void replaceTemporary(const char* before, const char* after) {
  for (std::atomic<const char*>& temporary : temporaries) {
    const char* expected = before;
    if (temporary.compare_exchange_strong(expected, after)) return;
  }
}

}  // namespace

OutputFile::OutputFile(const fs::path& path) : path_(path) {
  std::error_code none;
  // Through a symbolic link the file it points to is replaced, not the link.
  if (fs::is_symlink(path_, none)) {
    std::error_code endless;
    path_ = fs::weakly_canonical(path, endless);
    if (endless) fail(path, endless.message());
  }
  struct stat old {};
  const bool exists = stat(path_.c_str(), &old) == 0;
  if (exists && !S_ISREG(old.st_mode)) fail(path, "it is there and is not an ordinary file");

  temporary_ = (path_.parent_path() / ("." + path_.filename().string() + ".XXXXXX")).string();
  const int descriptor = mkstemp(temporary_.data());
  if (descriptor < 0) {
    temporary_.clear();
    fail(path, std::strerror(errno));
  }
  replaceTemporary(nullptr, temporary_.c_str());
  fchmod(descriptor, exists ? old.st_mode & 07777 : ordinaryMode());
  stream_ = fdopen(descriptor, "wb");
  if (stream_ == nullptr) {
    const int reason = errno;
    close(descriptor);
    removeTemporary();
    fail(path, std::strerror(reason));
  }
  // One thread writes, and CImg byte by byte: locking the stream for each of them takes most of the time.
  __fsetlocking(stream_, FSETLOCKING_BYCALLER);
}

OutputFile::~OutputFile() {
  if (stream_ != nullptr) std::fclose(stream_);
  if (!temporary_.empty()) removeTemporary();
}

void OutputFile::removeTemporary() {
  unlink(temporary_.c_str());
  forgetTemporary();
}

void OutputFile::forgetTemporary() {
  replaceTemporary(temporary_.c_str(), nullptr);
  temporary_.clear();
}

void OutputFile::commit() {
  errno = 0;
  const bool written = std::ferror(stream_) == 0 && std::fflush(stream_) == 0;
  const bool closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
  if (!written || !closed)
    fail(path_, errno != 0 ? std::strerror(errno)
                           : "a write failed; is there room, and are files of this size allowed?");
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, std::strerror(errno));
  forgetTemporary();
}

void removeTemporaryFiles() {
  for (const std::atomic<const char*>& temporary : temporaries) {
    if (const char* name = temporary) unlink(name);
  }
}

}  // namespace lavaray
