#include "render/projection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

namespace lavaray {
namespace {

// Whole numbers from floor(lower) to floor(upper) within [first, end).
std::pair<int, int> pixelRange(double lower, double upper, int first, int end) {
  const double from = std::clamp(std::floor(lower), double(first), double(end));
  const double to = std::clamp(std::floor(upper) + 1.0, from, double(end));
  return {static_cast<int>(from), static_cast<int>(to)};
}

}  // namespace

PixelBounds project(const Box& box, const ImagePlane& plane, const ImageSize& size) {
  const glm::dvec2 half = plane.size / 2.0;
  const glm::dvec2 scale = glm::dvec2(size.width, size.height) / plane.size;
  PixelBounds bounds{glm::dvec2(INFINITY), glm::dvec2(-INFINITY)};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p((corner & 1) != 0 ? box.upper.x : box.lower.x,
                       (corner & 2) != 0 ? box.upper.y : box.lower.y,
                       (corner & 4) != 0 ? box.upper.z : box.lower.z);
    const glm::dvec2 onPlane = glm::dvec2(p.x, -p.y) * (plane.distance / -p.z) + half;
    bounds.lower = glm::min(bounds.lower, onPlane * scale);
    bounds.upper = glm::max(bounds.upper, onPlane * scale);
  }
  return bounds;
}

Rectangle pixelsIn(const PixelBounds& bounds, const Rectangle& part) {
  const auto [x0, x1] = pixelRange(bounds.lower.x, bounds.upper.x, part.x0, part.x1);
  const auto [y0, y1] = pixelRange(bounds.lower.y, bounds.upper.y, part.y0, part.y1);
  return {x0, y0, x1, y1};
}

}  // namespace lavaray
