#include "library/file_stamps.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <tuple>

namespace lavaray {

std::timespec FileStamps::now() {
  std::timespec time{};
  clock_gettime(CLOCK_REALTIME_COARSE, &time);
  return time;
}

std::optional<FileStamps::Stamp> FileStamps::stampOf(const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return std::nullopt;
  return Stamp{status.st_ino, status.st_ctim.tv_sec, status.st_ctim.tv_nsec};
}

FileStamps::FileStamps(const std::vector<std::filesystem::path>& files, const std::timespec& before) {
  const std::timespec after = now();
  for (const std::filesystem::path& file : files) {
    const std::optional<Stamp> stamp = stampOf(file);
    stamps_.emplace_back(file, stamp);
    if (!stamp) continue;
    // A stamp of the future is of another computer's clock, and says nothing.
    const auto time = std::tie(stamp->seconds, stamp->nanoseconds);
    isUncertain_ |=
        time >= std::tie(before.tv_sec, before.tv_nsec) && time <= std::tie(after.tv_sec, after.tv_nsec);
  }
}

bool FileStamps::haveChanged() const {
  return isUncertain_ ||
         std::ranges::any_of(stamps_, [](const auto& entry) { return stampOf(entry.first) != entry.second; });
}

}  // namespace lavaray
