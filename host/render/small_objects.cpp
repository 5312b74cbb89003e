#include "render/small_objects.hpp"

#include <algorithm>

#include "bvh/primitives.hpp"
#include "render/projection.hpp"

namespace lavaray {
namespace {

constexpr double kSmallPixels = 2.0;

}  // namespace

std::vector<std::uint64_t> pixelsOfSmallObjects(const GpuScene& scene, const RenderSettings& settings) {
  std::vector<Box> boxes(scene.materials.size());
  for (const gpu::Primitive& primitive : scene.primitives)
    boxes[primitive.object].extend(boundingBox(primitive));

  const Rectangle& crop = settings.crop;
  std::vector<std::uint64_t> pixels;
  for (const Box& box : boxes) {
    if (!(box.upper.z < 0.0F)) continue;  // a plane, empty, or not in front of the camera as a whole
    const PixelBounds bounds = project(box, scene.imagePlane, settings.size);
    const glm::dvec2 extent = bounds.upper - bounds.lower;
    if (!(std::min(extent.x, extent.y) < kSmallPixels)) continue;
    const Rectangle pixelsOfBox = pixelsIn(bounds, crop);
    for (int y = pixelsOfBox.y0; y < pixelsOfBox.y1; ++y) {
      for (int x = pixelsOfBox.x0; x < pixelsOfBox.x1; ++x) {
        pixels.push_back(static_cast<std::uint64_t>(y - crop.y0) * crop.width() + (x - crop.x0));
      }
    }
  }
  std::sort(pixels.begin(), pixels.end());
  pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
  return pixels;
}

}  // namespace lavaray
