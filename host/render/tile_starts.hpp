#pragma once

#include <vector>

#include "bvh/flatten.hpp"
#include "render/settings.hpp"

namespace lavaray {

// Where in the hierarchy the camera rays of a tile of pixels may start, since they can reach nothing else: at
// one child of one node, as a packed group (see interface.h), or nowhere (0).
struct TileStarts {
  std::uint32_t shift;   // tiles are squares of 2^shift pixels, the last ones of a row or column less
  std::uint32_t across;  // tiles in a row
  std::vector<gpu::uint> groups;  // row by row, filled up to whole texels
};

// Whether nothing can be seen through a pixel, counted row by row in a crop of that width.
inline bool isEmpty(const TileStarts& starts, std::uint32_t pixel, std::uint32_t width) {
  const std::uint32_t row = (pixel / width) >> starts.shift;
  return starts.groups[std::size_t{row} * starts.across + ((pixel % width) >> starts.shift)] == 0;
}

// Of a picture of that size, those through which nothing can be seen.
std::uint64_t pixelsOfEmptyTiles(const TileStarts& starts, const ImageSize& size);

// For the tiles of the settings' crop.
TileStarts tileStarts(const GpuScene& scene, const Camera& camera, const RenderSettings& settings);

}  // namespace lavaray
