#pragma once

#include <lavaray/renderer.h>

#include <cstddef>

#include "lavaray/step_times.hpp"

namespace lavaray {

// Rays a second, from when the device began to trace until it ended; 0 where it traced nothing.
struct RayRates {
  double camera;
  double mirror;
  double shadow;

  [[nodiscard]] double all() const { return camera + mirror + shadow; }
};
RayRates ratesOf(const Statistics& render);

// All that --stats and --json say of a run.
struct RunReport {
  SceneSummary scene;
  ImageSize picture;  // the whole, of which only a crop may have been rendered
  Statistics render;
  DeviceInfo device;
  std::size_t peakMemoryBytes;  // of the process, so far
  StepTimes times;
};

std::size_t peakMemoryBytes();

}  // namespace lavaray
