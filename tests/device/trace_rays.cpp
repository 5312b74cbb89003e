#include "device/trace_rays.hpp"

#include "device/probe.hpp"
#include "trace1RaysProbeSpirv.spv.h"
#include "trace2RaysProbeSpirv.spv.h"
#include "trace4RaysProbeSpirv.spv.h"

namespace lavaray {

std::vector<gpu::ProbeHit> traceRays(const GpuScene& scene, const std::vector<gpu::ProbeRay>& rays,
                                     gpu::uint mode, unsigned raysPerLane) {
  const gpu::TraceConstants constants{static_cast<gpu::uint>(rays.size()),
                                      static_cast<gpu::uint>(scene.primitives.size()), mode, 0};
  std::span<const std::uint32_t> spirv = trace1RaysProbeSpirv;
  if (raysPerLane == 2) spirv = trace2RaysProbeSpirv;
  if (raysPerLane == 4) spirv = trace4RaysProbeSpirv;
  return runProbe<gpu::ProbeHit>(spirv, scene, rays, constants);
}

}  // namespace lavaray
