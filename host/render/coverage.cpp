#include "render/coverage.hpp"

#include <algorithm>

#include <glm/common.hpp>

#include "bvh/wide_bvh.hpp"
#include "render/projection.hpp"
#include "sampling/pixel_filter.hpp"

namespace lavaray {
namespace {

// Levels of the hierarchy to descend: the boxes there are smaller, and those behind the camera are apart from
// those in front of it.
constexpr int kLevels = 4;

// Extends `bounds` by the projections of the boxes below the node; returns false if one is not in front of
// the camera.
bool extendBelow(const GpuScene& scene, gpu::uint index, int levels, const ImageSize& size,
                 PixelBounds& bounds) {
  const gpu::BvhNode& node = scene.nodes[index];
  for (int i = 0; i < static_cast<int>(gpu::kNodeWidth); ++i) {
    const Box box = childBox(node, i);
    // There is no such child, or it is behind the camera, where nothing sees it directly.
    if (box.lower.x > box.upper.x || box.lower.z > 0.0F) continue;
    if (node.children[i] <= gpu::kMaxReference && levels > 0) {
      if (!extendBelow(scene, node.children[i], levels - 1, size, bounds)) return false;
      continue;
    }
    if (!(box.upper.z < 0.0F)) return false;
    const PixelBounds image = project(box, scene.imagePlane, size);
    bounds.lower = glm::min(bounds.lower, image.lower);
    bounds.upper = glm::max(bounds.upper, image.upper);
  }
  return true;
}

}  // namespace

Rectangle coverage(const GpuScene& scene, const RenderSettings& settings) {
  if (!scene.planes.empty()) return settings.crop;
  PixelBounds bounds{glm::dvec2(INFINITY), glm::dvec2(-INFINITY)};
  if (!scene.nodes.empty() && !extendBelow(scene, 0, kLevels, settings.size, bounds)) return settings.crop;
  const double margin = filterRadius(settings.filter) + kRoundingPixels;
  bounds.lower -= margin;
  bounds.upper += margin;
  return pixelsIn(bounds, settings.crop);
}

}  // namespace lavaray
