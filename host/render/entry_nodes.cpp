#include "render/entry_nodes.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include <glm/vec2.hpp>

#include "bvh/wide_bvh.hpp"
#include "render/projection.hpp"
#include "sampling/pixel_filter.hpp"

namespace lavaray {
namespace {

// Smaller tiles enter deeper but take longer to prepare; the array stays small for the largest images.
constexpr std::uint32_t kMinShift = 3;
constexpr std::uint64_t kMaxTiles = 1U << 18U;

// The directions of the camera rays through some pixels: x / -z and y / -z.
struct Slopes {
  glm::dvec2 lower;
  glm::dvec2 upper;
};

// Descends from the whole area to its tiles, each of which goes on where the square around it has stopped.
class Search {
 public:
  Search(const GpuScene& scene, const RenderSettings& settings, const Rectangle& area, EntryNodes& result)
      : scene_(scene), area_(area), result_(result) {
    half_ = scene.imagePlane.size / 2.0 / scene.imagePlane.distance;
    pixel_ = 2.0 * half_ / glm::dvec2(settings.size.width, settings.size.height);
    margin_ = filterRadius(settings.filter) + kRoundingPixels;
  }

  // Sets the groups of the tiles in a square of 2^level by 2^level. `group` holds everything that they reach.
  void run(std::uint32_t x, std::uint32_t y, std::uint32_t level, gpu::uint group) {
    if (x >= result_.across || y >= down()) return;
    group = descend(group, slopes(x, y, level));
    if (level == 0) {
      result_.groups[std::size_t{y} * result_.across + x] = group;
      return;
    }
    const std::uint32_t half = 1U << (level - 1);
    for (const std::uint32_t dy : {0U, half}) {
      for (const std::uint32_t dx : {0U, half}) run(x + dx, y + dy, level - 1, group);
    }
  }

 private:
  [[nodiscard]] std::uint32_t down() const {
    return (static_cast<std::uint32_t>(area_.height()) + (1U << result_.shift) - 1) >> result_.shift;
  }

  [[nodiscard]] Slopes slopes(std::uint32_t x, std::uint32_t y, std::uint32_t level) const {
    const double side = std::uint64_t{1} << (level + result_.shift);
    const glm::dvec2 first(area_.x0 + (double(x) * (1U << result_.shift)),
                           area_.y0 + (double(y) * (1U << result_.shift)));
    const glm::dvec2 lower = (first - margin_) * pixel_ - half_;
    const glm::dvec2 upper = (first + side + margin_) * pixel_ - half_;
    return {{lower.x, -upper.y}, {upper.x, -lower.y}};
  }

  // The group of the only child that the directions reach, as deep as there is such a child.
  [[nodiscard]] gpu::uint descend(gpu::uint group, const Slopes& slopes) const {
    while (group != 0) {
      const gpu::BvhNode& node = scene_.nodes[group >> gpu::kGroupNodeShift];
      const gpu::uint child = node.children[static_cast<int>(firstSlot(group))];
      if (child > gpu::kMaxReference) return group;
      int reached = 0;
      gpu::uint only = 0;
      for (gpu::uint slot = 0; slot < gpu::kNodeWidth; ++slot) {
        if (!reaches(slopes, childBox(scene_.nodes[child], static_cast<int>(slot)))) continue;
        ++reached;
        only = groupOf(child, slot);
      }
      if (reached > 1) return group;
      group = only;
    }
    return group;
  }

  // Whether a point of the box lies in one of the directions; never for a child that is not there.
  static bool reaches(const Slopes& slopes, const Box& box) {
    if (box.lower.x > box.upper.x || box.lower.z > 0.0F) return false;
    // The bounds of the directions are farthest out at one of these distances from the camera.
    const std::array<double, 2> depths{std::max(0.0, -double{box.upper.z}), -double{box.lower.z}};
    const auto isBeyond = [&](double bound, double side) {
      return side > std::max(bound * depths[0], bound * depths[1]);
    };
    return !isBeyond(slopes.upper.x, box.lower.x) && !isBeyond(-slopes.lower.x, -double{box.upper.x}) &&
           !isBeyond(slopes.upper.y, box.lower.y) && !isBeyond(-slopes.lower.y, -double{box.upper.y});
  }

  const GpuScene& scene_;
  const Rectangle& area_;
  EntryNodes& result_;
  glm::dvec2 half_;   // of the image plane, as slopes
  glm::dvec2 pixel_;  // likewise
  double margin_;     // around a pixel, in pixels
};

}  // namespace

std::uint64_t pixelsOfEmptyTiles(const EntryNodes& nodes, const ImageSize& size) {
  const int side = 1 << nodes.shift;
  std::uint64_t pixels = 0;
  std::size_t tile = 0;
  for (int y = 0; y < size.height; y += side) {
    for (int x = 0; x < size.width; x += side) {
      if (nodes.groups[tile++] != 0) continue;
      pixels += static_cast<std::uint64_t>(std::min(side, size.width - x)) *
                static_cast<std::uint64_t>(std::min(side, size.height - y));
    }
  }
  return pixels;
}

EntryNodes entryNodes(const GpuScene& scene, const RenderSettings& settings, const Rectangle& area) {
  // Where no ray traverses the hierarchy, no shader reads them.
  if (scene.nodes.empty() || scene.hasFewPrimitives)
    return {0, 0, std::vector<gpu::uint>(gpu::kEntryNodesPerTexel)};
  const auto width = static_cast<std::uint64_t>(area.width());
  const auto height = static_cast<std::uint64_t>(area.height());
  std::uint32_t shift = kMinShift;
  const auto tiles = [&](std::uint64_t pixels) { return (pixels + (1U << shift) - 1) >> shift; };
  while (tiles(width) * tiles(height) > kMaxTiles) ++shift;
  EntryNodes result{shift, static_cast<std::uint32_t>(tiles(width)), {}};
  const std::uint64_t texels =
      (tiles(width) * tiles(height) + gpu::kEntryNodesPerTexel - 1) / gpu::kEntryNodesPerTexel;
  result.groups.resize(texels * gpu::kEntryNodesPerTexel);
  const auto levels = static_cast<std::uint32_t>(std::bit_width(std::max(tiles(width), tiles(height)) - 1));
  Search(scene, settings, area, result).run(0, 0, levels, gpu::kRootGroup);
  return result;
}

}  // namespace lavaray
