#include "device/trace_rays.hpp"

#include "device/probe.hpp"
#include "traceProbeSpirv.spv.h"

namespace lavaray {

std::vector<gpu::ProbeHit> traceRays(const GpuScene& scene, const std::vector<gpu::ProbeRay>& rays,
                                     gpu::uint mode) {
  const gpu::TraceConstants constants{static_cast<gpu::uint>(rays.size()),
                                      static_cast<gpu::uint>(scene.primitives.size()), mode, 0};
  return runProbe<gpu::ProbeHit>(traceProbeSpirv, scene, rays, constants);
}

}  // namespace lavaray
