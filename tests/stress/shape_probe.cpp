#include "stress/shape_probe.hpp"

#include "device/probe.hpp"
#include "shapeProbeSpirv.spv.h"

namespace lavaray {

std::vector<float> intersectShapes(const std::vector<gpu::ShapeQuery>& queries) {
  const gpu::CountConstants constants{static_cast<gpu::uint>(queries.size())};
  return runProbe<float>(shapeProbeSpirv, GpuScene{}, queries, constants);
}

}  // namespace lavaray
