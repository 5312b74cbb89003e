#include "base/available_memory.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

namespace lavaray {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();
// Version 1 expresses the absence of a limit as one of nearly 2^63.
constexpr std::uint64_t kNoLimitOfVersion1 = std::uint64_t{1} << 60U;

// The number after the word that starts a line, as in /proc/meminfo and memory.stat.
std::optional<std::uint64_t> entry(const fs::path& file, const std::string& word) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string first;
    std::uint64_t number = 0;
    if (words >> first >> number && first == word) return number;
  }
  return std::nullopt;
}

// Empty if there is no such file or no number in it ("max").
std::optional<std::uint64_t> numberIn(const fs::path& file) {
  std::ifstream stream(file);
  std::uint64_t number = 0;
  return stream >> number ? std::optional(number) : std::nullopt;
}

std::uint64_t difference(std::uint64_t limit, std::uint64_t used) {
  return limit - std::min(limit, used);
}

std::uint64_t kibibytes(const char* file, const char* word) {
  return 1024 * entry(file, word).value_or(0);
}

void tighten(AvailableMemory& available, std::uint64_t bytes, const char* limit) {
  if (bytes < available.bytes) available = {bytes, limit};
}

void tightenByLimit(AvailableMemory& available, int resource, const char* used, const char* text) {
  rlimit limit{};
  if (getrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return;
  tighten(available, difference(limit.rlim_cur, kibibytes("/proc/self/status", used)), text);
}

// Applies the limits of a group and of all groups around it. In a container the group's path may not exist:
// there the root of the mount is the group. Page cache does not count as used, since the system gives it
// back.
void tightenByGroups(AvailableMemory& available, const fs::path& mount, fs::path group, bool isVersion2,
                     std::uint64_t swap) {
  for (group = group.relative_path();; group = group.parent_path()) {
    const fs::path folder = mount / group;
    const auto limit = numberIn(folder / (isVersion2 ? "memory.max" : "memory.limit_in_bytes"));
    if (limit && *limit < kNoLimitOfVersion1) {
      const auto used =
          numberIn(folder / (isVersion2 ? "memory.current" : "memory.usage_in_bytes")).value_or(0);
      const char* const prefix = isVersion2 ? "" : "total_";
      std::uint64_t files = 0;
      for (const char* kind : {"inactive_file", "active_file"})
        files += entry(folder / "memory.stat", std::string(prefix) + kind).value_or(0);
      tighten(available, difference(*limit, difference(used, files)) + swap,
              "the limit of this control group (container or job) leaves");
    }
    if (group.empty()) return;
  }
}

}  // namespace

AvailableMemory availableMemory() {
  const std::uint64_t swap = kibibytes("/proc/meminfo", "SwapFree:");
  AvailableMemory result{kNoLimit, {}};
  if (const auto available = entry("/proc/meminfo", "MemAvailable:"))
    tighten(result, 1024 * *available + swap, "this machine has left");
  tightenByLimit(result, RLIMIT_AS, "VmSize:", "the limit of this process (ulimit -v) leaves");
  tightenByLimit(result, RLIMIT_DATA, "VmData:", "the limit of this process (ulimit -d) leaves");
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    // Such as `0::/user.slice`, or `4:memory:/job` in version 1.
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::string group = line.substr(second + 1);
    if (controllers == ",,") tightenByGroups(result, "/sys/fs/cgroup", group, true, swap);
    if (controllers.find(",memory,") != std::string::npos)
      tightenByGroups(result, "/sys/fs/cgroup/memory", group, false, swap);
  }
  return result;
}

std::string inGigabytes(std::uint64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, bytes < 100'000'000 ? "%.3f GB" : "%.1f GB",
                static_cast<double>(bytes) / 1e9);
  return text;
}

}  // namespace lavaray
