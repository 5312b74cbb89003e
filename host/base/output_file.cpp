#include "base/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <list>
#include <system_error>

#include "base/errors.hpp"
#include "base/printable.hpp"

namespace lavaray {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& name, const std::string& why) {
  throw Error(ExitCode::kOutput, printable(name.native()) + ": cannot be written: " + why, name.string());
}

WriteTarget findTarget(const fs::path& name) {
  try {
    return WriteTarget(name);
  } catch (const std::system_error& error) {
    fail(name, error.code().message());
  }
}

bool isMountPoint(const fs::path& file) {
  struct statx status {};
  return statx(AT_FDCWD, file.c_str(), AT_SYMLINK_NOFOLLOW, 0, &status) == 0 &&
         (status.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
}

// Why this file cannot be replaced with another; empty if it can. Asks the system itself: rmdir() refuses
// every ordinary file, but with ENOTDIR only if the file could be removed from its folder. It could not if it
// is immutable, or belongs to another user in a sticky folder.
std::string whyIrreplaceable(const fs::path& file) {
  if (isMountPoint(file)) return "something is mounted there";
  if (rmdir(file.c_str()) == 0 || errno == ENOTDIR) return {};
  return std::strerror(errno);
}

// Why no file can have this name; empty if one can, or already has.
std::string whyImpossible(const fs::path& file) {
  struct stat status {};
  return lstat(file.c_str(), &status) == 0 || errno == ENOENT ? std::string() : std::strerror(errno);
}

}  // namespace

OutputFile::OutputFile(const OutputName& output)
    : name_(output.file),
      target_(findTarget(output.file)),
      claim_(target_, output.file, output.option, output.mayReplace) {
  if (target_.old) {
    if (!S_ISREG(target_.old->st_mode)) fail(name_, "it is there and is not an ordinary file");
    if (const std::string reason = whyIrreplaceable(target_.path); !reason.empty())
      fail(name_, "what is there cannot be replaced: " + reason);
  } else if (const std::string reason = whyImpossible(target_.path); !reason.empty()) {
    fail(name_, reason);
  }
  try {
    temporary_.emplace(target_.path);
    if (target_.old) fchmod(temporary_->descriptor(), target_.old->st_mode & 07777);
    stream_.emplace(temporary_->descriptor());
  } catch (const std::system_error& error) {
    fail(name_, error.code().message());
  }
}

void OutputFile::commit() {
  if (const std::string reason = stream_->flush(); !reason.empty()) fail(name_, reason);
  // Some network file systems report only on close that there is no space.
  const int copy = dup(temporary_->descriptor());
  if (copy < 0 || close(copy) != 0) fail(name_, std::strerror(errno));
  try {
    temporary_->giveName();
  } catch (const std::system_error& error) {
    fail(name_, error.code().message());
  }
  if (temporary_->replaceTarget()) return;
  const std::string reason = std::strerror(errno);
  const fs::path kept = temporary_->keep();
  fail(name_, reason + "; it is complete, and stays as " + printable(kept.native()));
}

void checkOutputs(std::span<const OutputName> outputs) {
  std::list<WriteClaim> claims;
  for (const OutputName& output : outputs) {
    try {
      claims.emplace_back(WriteTarget(output.file), output.file, output.option, output.mayReplace);
    } catch (const std::system_error&) {
      // A loop of links: opening the file will report it.
    }
  }
}

}  // namespace lavaray
