#pragma once

#include <filesystem>
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

// These have a file for each device in `folder`, or none where that is empty.

// Whether the folder can be written to. Makes it where it is missing.
bool canKeepTunings(const std::filesystem::path& folder);
// What was measured on the device, with the same driver and by the same version of this program; empty if
// nothing was, or it cannot be read.
std::vector<TuningTime> readTuningFile(const std::filesystem::path& folder,
                                       const vulkan::DeviceDescription& device);
// Throws Error(kOutput) if it cannot be written. The folder's name is not empty.
void writeTuningFile(const std::filesystem::path& folder, const vulkan::DeviceDescription& device,
                     std::span<const TuningTime> times);

}  // namespace lavaray
