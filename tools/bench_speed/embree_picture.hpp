#pragma once

#include <span>

#include "bvh/frame.hpp"
#include "embree.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace lavaray::bench {

// Renders the scene's picture with single rays of Embree: camera rays, a shadow ray to each light, and
// lavaray's illumination. `embree` holds the shapes in the frame. `rgb` is row by row.
void renderWithEmbree(RTCScene embree, const Scene& scene, const Frame& frame, const ImageSize& size,
                      unsigned threads, std::span<float> rgb);

}  // namespace lavaray::bench
