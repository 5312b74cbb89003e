#pragma once

#include <span>
#include <vector>

#include "render/settings.hpp"
#include "vulkan/device.hpp"

namespace lavaray {

// How long a device takes for a test picture that is traced in one way.
struct TuningTime {
  Tuning tuning;
  double seconds;
};

// What suits most devices of a kind, as far as known: lavapipe of Mesa 22.3 to 26.2 (docs/drivers.md), and a
// GPU no better than another way.
Tuning usualTuning(bool isCpu);

// Whether a render has so much to trace that it may gain as much as measureTunings() takes, and later ones
// more.
bool isWorthMeasuring(bool isCpu, std::uint32_t lights, const RenderSettings& settings);

// Traces a test picture of some milliseconds several times in each way that may be the fastest. The first is
// the usual one. It takes some seconds, in most of which the
// driver compiles. Throws Error(kDevice).
std::vector<TuningTime> measureTunings(vulkan::Device& device);

// The fastest of at least one; the first, unless another one is clearly faster.
Tuning fastest(std::span<const TuningTime> times);

}  // namespace lavaray
