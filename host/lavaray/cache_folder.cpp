#include "lavaray/cache_folder.hpp"

#include <cstdlib>

namespace lavaray {
namespace {

std::filesystem::path variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

std::filesystem::path cacheFolder() {
  if (const auto folder = variable("XDG_CACHE_HOME"); folder.is_absolute()) return folder / "lavaray";
  if (const auto home = variable("HOME"); home.is_absolute()) return home / ".cache" / "lavaray";
  return {};
}

}  // namespace lavaray
