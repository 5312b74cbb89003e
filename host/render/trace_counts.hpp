#pragma once

#include <cstdint>

namespace lavaray {

// What a tracer has done.
struct TraceCounts {
  std::uint64_t dispatches = 0;
  std::uint64_t givenUp = 0;         // invocations that another dispatch had to do again
  std::uint64_t samples = 0;         // camera rays
  std::uint64_t skippedSamples = 0;  // through tiles of the picture that show nothing
  // These are counted only if the settings ask for it.
  std::uint64_t shadowRays = 0;
  std::uint64_t skippedShadowRays = 0;  // their light would add nothing, or nothing that shows
  std::uint64_t mirrorRays = 0;
};

}  // namespace lavaray
