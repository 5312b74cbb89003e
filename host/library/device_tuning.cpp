#include "library/device_tuning.hpp"

#include <array>
#include <charconv>

#include "base/errors.hpp"
#include "library/tuning_file.hpp"

namespace lavaray {

std::optional<TuningChoice> tuningChoice(const std::string& way) {
  if (way == "auto") return TuningChoice{};
  if (way == "measure") return TuningChoice{.kind = TuningChoice::Kind::kMeasure, .given = {}};
  for (const bool inStorage : {false, true}) {
    // Rays that are not given are as many as usual on a CPU.
    if (way == sceneReadAs(inStorage))
      return TuningChoice{.kind = TuningChoice::Kind::kGiven,
                          .given = {inStorage, usualTuning(true).raysPerLane}};
  }
  const std::optional<Tuning> given = tuningNamed(way);
  if (!given) return std::nullopt;
  return TuningChoice{.kind = TuningChoice::Kind::kGiven, .given = *given};
}

DeviceTuning::DeviceTuning(const TuningChoice& choice, const std::filesystem::path& folder,
                           vulkan::Device& device)
    : choice_(choice), folder_(folder), device_(device) {
  if (choice.kind == TuningChoice::Kind::kMeasure) measure();
  if (choice.kind == TuningChoice::Kind::kAuto) times_ = readTuningFile(folder_, device.description());
}

void DeviceTuning::prepareFor(std::uint32_t lights, const RenderSettings& settings) {
  const std::lock_guard lock(mutex_);
  const bool isKnown = choice_.kind != TuningChoice::Kind::kAuto || !times_.empty();
  if (isKnown || !isWorthMeasuring(isCpu(), lights, settings) || !canKeepTunings(folder_)) return;
  measure();
}

void DeviceTuning::measure() {
  times_ = measureTunings(device_);
  if (folder_.empty()) return;
  try {
    writeTuningFile(folder_, device_.description(), times_);
  } catch (const Error& error) {
    whyNotKept_ = error.what();
  }
}

Tuning DeviceTuning::get() const {
  const std::lock_guard lock(mutex_);
  return chosen();
}

Tuning DeviceTuning::chosen() const {
  if (choice_.kind == TuningChoice::Kind::kGiven) return choice_.given;
  return times_.empty() ? usualTuning(isCpu()) : fastest(times_);
}

std::string DeviceTuning::description() const {
  const std::lock_guard lock(mutex_);
  const std::string name = tuningName(chosen());
  if (choice_.kind == TuningChoice::Kind::kGiven) return name + ", as asked for";
  if (times_.empty()) return name + ", the usual one, as none was measured on this device";
  std::string measured;
  for (const TuningTime& time : times_) {
    std::array<char, 32> number{};
    const auto end =
        std::to_chars(number.begin(), number.end(), 1e3 * time.seconds, std::chars_format::fixed, 2);
    measured += (measured.empty() ? "" : ", ") + tuningName(time.tuning) + ' ' +
                std::string(number.begin(), end.ptr) + " ms";
  }
  return name + ", measured on this device: " + measured +
         (whyNotKept_.empty() ? "" : "; not kept: " + whyNotKept_);
}

}  // namespace lavaray
