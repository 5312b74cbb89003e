#pragma once

#include <filesystem>
#include <string>

namespace lavaray {

// SCENE `-`. It is called stdin in messages, and where `{}` stands for a scene's name.
inline constexpr const char* kStandardInputName = "stdin";
bool isStandardInput(const std::filesystem::path& scene);
std::string shownName(const std::filesystem::path& scene);

// All that it holds. Throws Error(kUsage) if it is a terminal, Error(kInput) if it cannot be read.
std::string readStandardInput();

}  // namespace lavaray
