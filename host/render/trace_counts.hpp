#pragma once

#include <array>
#include <cstdint>

#include "interface.h"

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
  // By gpu::kTurns...: of the loops that search the hierarchy.
  std::array<std::uint64_t, gpu::kTurnKinds> turns{};

  // The share of lanes that had something to do in the turns of their subgroups; 0 where there were none.
  [[nodiscard]] double lanesInUse(gpu::uint turnsOfLanes, gpu::uint lanesOfSubgroups) const {
    const auto lanes = static_cast<double>(turns[lanesOfSubgroups]);
    return lanes > 0.0 ? static_cast<double>(turns[turnsOfLanes]) / lanes : 0.0;
  }
  [[nodiscard]] double nearestHitLanesInUse() const {
    return lanesInUse(gpu::kTurnsForNearestHit, gpu::kLanesForNearestHit);
  }
  [[nodiscard]] double shadowLanesInUse() const {
    return lanesInUse(gpu::kTurnsForAnyHit, gpu::kLanesForAnyHit);
  }
};

}  // namespace lavaray
