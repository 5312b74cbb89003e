#pragma once

#include <filesystem>

namespace lavaray {

// The user's folder for what the program keeps, by the XDG Base Directory Specification; empty if there is
// none.
std::filesystem::path cacheFolder();

}  // namespace lavaray
