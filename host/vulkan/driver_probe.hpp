#pragma once

#include <cstdint>
#include <string>

namespace lavaray::vulkan {

enum class DriverState {
  kWorks,
  kNoDevice,  // it finds nothing that it can drive, as most drivers on most machines
  kUnused,    // the user's variables leave it out
  kFaulty,
};

struct DriverAnswer {
  DriverState state = DriverState::kFaulty;
  std::string
      text;  // what is to be known of it, to be said after the manifest: `, whose driver has no device`
};

// Loads a driver as the loader would and asks it for its devices, in a child process: what it prints, leaves
// behind or ends in does not touch this one. `library` is a path, or a name for the system to look up.
DriverAnswer probeDriver(const std::string& library);

}  // namespace lavaray::vulkan
