#pragma once

#include <span>

#include "embree.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace lavaray::bench {

// Renders the scene's picture with Embree, single rays: camera rays, a shadow ray to each light, and the
// illumination that lavaray computes. `embree` holds the shapes relative to the camera. `rgb` is row by row.
void renderWithEmbree(RTCScene embree, const Scene& scene, const ImageSize& size, unsigned threads,
                      std::span<float> rgb);

}  // namespace lavaray::bench
