#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/tuning.hpp"
#include "vulkan/instance.hpp"

namespace lavaray {

// How the scene is read: `texels` or `storage`.
std::string sceneReadAs(bool inStorage);
// Like `texels,4`: how the scene is read, and the rays that an invocation traces together.
std::string tuningName(const Tuning& tuning);
std::optional<Tuning> tuningNamed(const std::string& name);

// Whether there is a folder for such files that can be written to. Makes it where it is missing.
bool canKeepTunings();
// What was measured on the device, with the same driver and by the same version of this program; empty if
// nothing was, or it cannot be read.
std::vector<TuningTime> readTuningFile(const vulkan::DeviceDescription& device);
// Throws Error(kOutput) if it cannot be written, or there is no folder for such files.
void writeTuningFile(const vulkan::DeviceDescription& device, std::span<const TuningTime> times);

}  // namespace lavaray
