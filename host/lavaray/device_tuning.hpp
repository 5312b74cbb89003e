#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "command_line/progress.hpp"
#include "lavaray/options.hpp"
#include "render/tuning.hpp"
#include "vulkan/device.hpp"

namespace lavaray {

// The value of --tuning that a text stands for; empty if there is none.
std::optional<TuningChoice> tuningChoice(const std::string& text);
inline constexpr const char* kTuningChoices =
    "auto, measure, texels or storage, the latter two with ,1 ,2 or ,4 as well";

// The way to trace on a device. What was measured on it is kept for later runs, in a file for each device,
// driver and version of this program, in the user's cache folder. Not for several threads at a time.
class DeviceTuning {
 public:
  // Looks for what was measured before, or measures if that is asked for.
  DeviceTuning(const TuningChoice& choice, vulkan::Device& device);

  // Measures first, if that was never done, the render is worth it and later ones will gain, too.
  void prepareFor(std::uint32_t lights, const RenderSettings& settings, Progress& progress);
  [[nodiscard]] Tuning get() const;
  // For the user: what is chosen, and why.
  [[nodiscard]] std::string description() const;

 private:
  void measure();
  [[nodiscard]] bool isCpu() const { return device_.description().isCpu; }

  TuningChoice choice_;
  vulkan::Device& device_;
  std::vector<TuningTime> times_;  // empty where nothing was measured
  std::string whyNotKept_;
};

}  // namespace lavaray
