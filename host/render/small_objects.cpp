#include "render/small_objects.hpp"

#include <algorithm>
#include <cmath>

#include <glm/vec2.hpp>

#include "core/primitives.hpp"

namespace lavaray {
namespace {

constexpr double kSmallPixels = 2.0;

struct PixelBounds {
  glm::dvec2 lower{INFINITY};
  glm::dvec2 upper{-INFINITY};
};

// Bounds, in output pixels, of the image of a box, which lies in front of the camera.
PixelBounds project(const Box& box, const Camera& camera, const ImageSize& size) {
  const ImageSize plane = imageSize(camera).value();
  const glm::dvec2 half(plane.width / 2.0, plane.height / 2.0);
  const glm::dvec2 scale(static_cast<double>(size.width) / plane.width,
                         static_cast<double>(size.height) / plane.height);
  PixelBounds bounds;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p((corner & 1) != 0 ? box.upper.x : box.lower.x,
                       (corner & 2) != 0 ? box.upper.y : box.lower.y,
                       (corner & 4) != 0 ? box.upper.z : box.lower.z);
    const glm::dvec2 onPlane = glm::dvec2(p.x, -p.y) * (camera.focalLength / -p.z) + half;
    bounds.lower = glm::min(bounds.lower, onPlane * scale);
    bounds.upper = glm::max(bounds.upper, onPlane * scale);
  }
  return bounds;
}

// Whole numbers from floor(lower) to floor(upper) within [first, end).
std::pair<int, int> pixelRange(double lower, double upper, int first, int end) {
  const double from = std::clamp(std::floor(lower), double(first), double(end));
  const double to = std::clamp(std::floor(upper) + 1.0, double(first), double(end));
  return {static_cast<int>(from), static_cast<int>(to)};
}

}  // namespace

std::vector<std::uint64_t> pixelsOfSmallObjects(const GpuScene& scene, const Camera& camera,
                                                const RenderSettings& settings) {
  std::vector<Box> boxes(scene.materials.size());
  for (const gpu::Primitive& primitive : scene.primitives)
    boxes[primitive.object].extend(boundingBox(primitive));

  const Rectangle& crop = settings.crop;
  std::vector<std::uint64_t> pixels;
  for (const Box& box : boxes) {
    if (!(box.upper.z < 0.0F)) continue;  // a plane, empty, or not in front of the camera as a whole
    const PixelBounds bounds = project(box, camera, settings.size);
    const glm::dvec2 extent = bounds.upper - bounds.lower;
    if (!(std::min(extent.x, extent.y) < kSmallPixels)) continue;
    const auto [x0, x1] = pixelRange(bounds.lower.x, bounds.upper.x, crop.x0, crop.x1);
    const auto [y0, y1] = pixelRange(bounds.lower.y, bounds.upper.y, crop.y0, crop.y1);
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        pixels.push_back(static_cast<std::uint64_t>(y - crop.y0) * (crop.x1 - crop.x0) + (x - crop.x0));
      }
    }
  }
  std::sort(pixels.begin(), pixels.end());
  pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
  return pixels;
}

}  // namespace lavaray
