#pragma once

#include <vector>

#include "bvh/flatten.hpp"
#include "device/shaders/probe.h"

namespace lavaray {

// ProbeHit::order of a ray that hits nothing.
inline constexpr std::uint32_t kMiss = 0xFFFFFFFF;
// ProbeRay::skipped of a ray that may hit everything.
inline constexpr std::uint32_t kNoSkip = 0xFFFFFFFF;

// Traces the rays on the test device; `mode` is gpu::kTraceClosest, gpu::kTraceAny or gpu::kTraceBruteForce.
// Planes are left out: they are in no tree. An invocation traces so many consecutive rays together: 1, 2
// or 4.
std::vector<gpu::ProbeHit> traceRays(const GpuScene& scene, const std::vector<gpu::ProbeRay>& rays,
                                     gpu::uint mode, unsigned raysPerLane = 1);

}  // namespace lavaray
