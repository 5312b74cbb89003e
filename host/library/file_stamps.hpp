#pragma once

#include <ctime>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace lavaray {

// Whether files are still what they were when they were read.
class FileStamps {
 public:
  // The time by which file systems stamp what changes now.
  static std::timespec now();

  FileStamps() = default;
  // `before` is a time before they were read, if they are there: a change after it may have been missed.
  FileStamps(const std::vector<std::filesystem::path>& files, const std::timespec& before);

  [[nodiscard]] bool haveChanged() const;

 private:
  // Of the last change of a file; a file that replaces it by its name has another one.
  struct Stamp {
    ino_t number;
    time_t seconds;
    long nanoseconds;
    bool operator==(const Stamp&) const = default;
  };
  static std::optional<Stamp> stampOf(const std::filesystem::path& file);

  std::vector<std::pair<std::filesystem::path, std::optional<Stamp>>> stamps_;
  bool isUncertain_ = false;
};

}  // namespace lavaray
