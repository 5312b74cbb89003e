#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "render/tuning.hpp"
#include "vulkan/device.hpp"

namespace lavaray {

// How the way to trace on a device is chosen: TuningOptions::way.
struct TuningChoice {
  enum class Kind { kAuto, kMeasure, kGiven };
  Kind kind = Kind::kAuto;
  Tuning given;
};

// Empty where there is no such way.
std::optional<TuningChoice> tuningChoice(const std::string& way);

// The way to trace on a device. What was measured on it is kept in a file for each device, driver and version
// of this program. Any thread may call it.
class DeviceTuning {
 public:
  // Looks in the folder for what was measured before, or measures if that is asked for. Without a folder
  // nothing is kept. The device must outlive it.
  DeviceTuning(const TuningChoice& choice, const std::filesystem::path& folder, vulkan::Device& device);

  // Measures first, if that was never done, the render is worth it and later ones will gain, too.
  void prepareFor(std::uint32_t lights, const RenderSettings& settings);
  [[nodiscard]] Tuning get() const;
  // For the user: what is chosen, and why.
  [[nodiscard]] std::string description() const;

 private:
  void measure();
  [[nodiscard]] Tuning chosen() const;  // with the mutex held
  [[nodiscard]] bool isCpu() const { return device_.description().isCpu; }

  TuningChoice choice_;
  std::filesystem::path folder_;
  vulkan::Device& device_;
  mutable std::mutex mutex_;       // of the following
  std::vector<TuningTime> times_;  // empty where nothing was measured
  std::string whyNotKept_;
};

}  // namespace lavaray
