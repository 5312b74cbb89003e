#include "base/file_claims.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <map>
#include <mutex>
#include <system_error>
#include <utility>

#include "base/errors.hpp"
#include "base/printable.hpp"

namespace lavaray {
namespace fs = std::filesystem;
namespace {

// The system's own limit for the links in a path.
constexpr int kMaxLinks = 40;

constexpr const char* kWouldReplace = " would replace";

struct Claim {
  WriteTarget target;
  fs::path name;
  std::string option;
  fs::path mayReplace;
};

std::atomic<bool> protectsInputs{false};
std::mutex mutex;
std::map<fs::path, std::string> readFiles;  // what each is, by the name it was read by
std::map<int, Claim> claims;
int lastClaim = 0;

bool isSameFile(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

std::optional<struct stat> statusOf(const fs::path& file) {
  struct stat status {};
  return stat(file.c_str(), &status) == 0 ? std::optional(status) : std::nullopt;
}

std::string named(const fs::path& file) {
  return printable(file.native());
}

[[noreturn]] void failRead(const std::string& output, const std::string& what, const fs::path& file) {
  throw Error(ExitCode::kUsage,
              output + " " + what + " " + named(file) + ", which is read; give another name");
}

// Looks up each file by name anew: an editor replaces a file with another of the same name, and the system
// reuses the old one's inode number for whatever is created next.
void failWhereRead(const struct stat& target, const std::string& output, const fs::path& except) {
  for (const auto& [file, what] : readFiles) {
    if (file == except) continue;
    const std::optional<struct stat> read = statusOf(file);
    if (read && isSameFile(*read, target)) failRead(output, what, file);
  }
}

}  // namespace

void protectInputs() {
  protectsInputs = true;
}

void noteRead(const fs::path& file, const std::string& what) {
  if (!protectsInputs) return;
  const std::lock_guard lock(mutex);
  const std::string& known = readFiles.emplace(file, what).first->second;
  if (claims.empty()) return;
  const std::optional<struct stat> read = statusOf(file);
  for (const auto& [number, claim] : claims) {
    const bool isClaimed = read && claim.target.old && isSameFile(*read, *claim.target.old);
    if (isClaimed && file != claim.mayReplace)
      failRead(claim.option + " " + named(claim.name) + kWouldReplace, known, file);
  }
}

void forgetRead(const fs::path& file) {
  const std::lock_guard lock(mutex);
  readFiles.erase(file);
}

void checkNotRead(int descriptor, const std::string& output) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return;
  const std::lock_guard lock(mutex);
  failWhereRead(status, output + " is", {});
}

WriteTarget::WriteTarget(const fs::path& name) : path(name) {
  std::error_code none;
  for (int links = 0; fs::is_symlink(path, none); ++links) {
    if (links == kMaxLinks) throw std::system_error(ELOOP, std::generic_category());
    // operator/ drops the parent if the target is absolute.
    path = path.parent_path() / fs::read_symlink(path);
  }
  old = statusOf(path);
}

fs::path WriteTarget::folder() const {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

bool WriteTarget::isSameAs(const WriteTarget& other) const {
  if (old || other.old) return old && other.old && isSameFile(*old, *other.old);
  if (path.filename() != other.path.filename()) return false;
  const std::optional<struct stat> mine = statusOf(folder());
  const std::optional<struct stat> others = statusOf(other.folder());
  return mine && others && isSameFile(*mine, *others);
}

WriteClaim::WriteClaim(const WriteTarget& target, const fs::path& name, const std::string& option,
                       const fs::path& mayReplace) {
  const std::lock_guard lock(mutex);
  const std::string output = option + " " + named(name);
  if (target.old) failWhereRead(*target.old, output + kWouldReplace, mayReplace);
  for (const auto& [number, claim] : claims) {
    if (!claim.target.isSameAs(target)) continue;
    throw Error(ExitCode::kUsage, claim.option + " " + named(claim.name) + " and " + output +
                                      " are the same file; give them files of their own");
  }
  number_ = ++lastClaim;
  claims.emplace(number_, Claim{target, name, option, mayReplace});
}

WriteClaim::~WriteClaim() {
  const std::lock_guard lock(mutex);
  claims.erase(number_);
}

}  // namespace lavaray
