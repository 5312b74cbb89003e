#pragma once

#include <vector>

#include "stress/shaders/stress_probes.h"

namespace lavaray {

// The distances that the renderer's intersection functions find on the test device; infinity is a miss.
std::vector<float> intersectShapes(const std::vector<gpu::ShapeQuery>& queries);

}  // namespace lavaray
