#pragma once

#include "bvh/flatten.hpp"
#include "render/settings.hpp"

namespace lavaray {

// A rectangle of the crop outside of which every pixel is black, since no sample of it can meet anything.
// Empty (x0 == x1 or y0 == y1) where that holds for the whole crop.
Rectangle coveredPart(const GpuScene& scene, const Camera& camera, const RenderSettings& settings);

}  // namespace lavaray
