#pragma once

#include <glm/vec2.hpp>

#include "base/rectangle.hpp"
#include "bvh/box.hpp"
#include "scene/camera.hpp"

namespace lavaray {

// A camera ray that misses a box by less than this may still hit it in the shader, which rounds. Its rounding
// is far smaller.
inline constexpr double kRoundingPixels = 0.5;

struct PixelBounds {
  glm::dvec2 lower;
  glm::dvec2 upper;
};

// Bounds of a box's projection, in pixels of an image of that size from its top left corner. The box is in
// the camera's coordinates and lies in front of it: box.upper.z < 0.
PixelBounds project(const Box& box, const ImagePlane& plane, const ImageSize& size);

// The pixels of `part` that have a point within the bounds; empty (x0 == x1 or y0 == y1) if none has.
Rectangle pixelsIn(const PixelBounds& bounds, const Rectangle& part);

}  // namespace lavaray
