#pragma once

#include <cstdint>
#include <string>

namespace lavaray::vulkan {

enum class DriverState {
  kWorks,
  kNoDevice,  // it finds nothing to drive, like most drivers on most machines
  kUnused,    // an environment variable leaves it out
  kFaulty,
};

struct DriverAnswer {
  DriverState state = DriverState::kFaulty;
  // What there is to know of it, worded to follow the manifest's name: `, whose driver has no device`.
  std::string text;
};

// Loads a driver as the loader would and asks it for its devices. A child process does so, so that nothing
// the driver prints or leaves behind, nor a crash, affects this one. `library` is a path, or a name for the
// system to look up.
DriverAnswer probeDriver(const std::string& library);

}  // namespace lavaray::vulkan
