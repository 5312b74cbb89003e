#pragma once

#include <lavaray/statistics.h>
#include <optional>
#include <string>
#include <vector>

namespace lavaray {

struct DiffOptions {
  std::string image;
  std::string reference;
  std::vector<std::string> from;
  std::string output;
  std::string report;
  std::string json;
  std::string name;
  std::string driver;
  DifferenceLimits limits;
  bool info = false;
};

// Nothing if the command line asked for help or the version, which have been printed then. Throws
// Error(kUsage).
std::optional<DiffOptions> parseDiffOptions(int argc, const char* const* argv);

}  // namespace lavaray
