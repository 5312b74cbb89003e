#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera.hpp"

namespace lavaray::bench {

struct Options {
  std::vector<std::string> scenes;  // names, see sceneNames()
  std::filesystem::path meshFolder;
  ImageSize size{512, 512};
  std::vector<unsigned> raysPerLane{4};  // that lavaray traces together
  std::vector<std::string> parts{"rays", "pictures", "builds"};
  int rounds = 7;
  unsigned threads = 1;        // of builds and peers; the device has its own
  std::string device;          // empty: the best one
  std::filesystem::path json;  // empty: none
};

// The command line's options; nothing if it asked for help, which has been printed then. Throws
// Error(kUsage).
std::optional<Options> parseOptions(int argc, const char* const* argv);

}  // namespace lavaray::bench
