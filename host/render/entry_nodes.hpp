#pragma once

#include <cstdint>
#include <vector>

#include "bvh/gpu_scene.hpp"
#include "render/settings.hpp"

namespace lavaray {

// Where the camera rays of each tile of pixels enter the hierarchy: at one child of one node, as a packed
// group (see interface.h), since they can reach nothing else, or nowhere (0).
struct EntryNodes {
  std::uint32_t shift;            // tiles are squares of 2^shift pixels, smaller at the right and the bottom
  std::uint32_t across;           // tiles in a row
  std::vector<gpu::uint> groups;  // row by row, padded to whole texels
};

// Whether nothing can be seen through a pixel, numbered row by row in an area of that width.
inline bool isEmpty(const EntryNodes& nodes, std::uint32_t pixel, std::uint32_t width) {
  const std::uint32_t row = (pixel / width) >> nodes.shift;
  return nodes.groups[std::size_t{row} * nodes.across + ((pixel % width) >> nodes.shift)] == 0;
}

// Of an area of that size, the number of pixels through which nothing can be seen.
std::uint64_t pixelsOfEmptyTiles(const EntryNodes& nodes, const ImageSize& size);

// For the tiles of an area of the picture, counted from its top left pixel.
EntryNodes entryNodes(const GpuScene& scene, const RenderSettings& settings, const Rectangle& area);

}  // namespace lavaray
