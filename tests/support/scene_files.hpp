#pragma once

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene_reader.hpp"

namespace lavaray {

// The project's own scenes, for tests that go through them all.

// Names without folder and ending, sorted.
inline std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(LAVARAY_SCENES_DIR)) {
    if (entry.path().extension() == ".txt") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

inline Scene readNamed(const std::string& name) {
  return readScene(std::filesystem::path(LAVARAY_SCENES_DIR) / (name + ".txt"));
}

// The scene's name as a part of a test's name, which must be an identifier.
inline std::string asIdentifier(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

inline bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

}  // namespace lavaray
