#pragma once

#include <filesystem>
#include <string>

namespace lavaray {

// SCENE `-`. In messages, and where `{}` stands for a scene's name, it is called stdin.
inline constexpr const char* kStandardInputName = "stdin";
bool isStandardInput(const std::filesystem::path& scene);
std::string shownName(const std::filesystem::path& scene);

// All that can be read from it. Throws Error(kUsage) where it is a terminal, Error(kInput) where it cannot be
// read.
std::string readStandardInput();

}  // namespace lavaray
