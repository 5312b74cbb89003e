#pragma once

#include <optional>
#include <string>
#include <vector>

#include <lavaray/types.h>

namespace lavaray {

using v0::kPixelFilterNames;
using v0::PixelFilter;

std::optional<PixelFilter> pixelFilter(const std::string& name);
std::string pixelFilterName(PixelFilter filter);

// The largest offset from the pixel's centre, in pixels.
double filterRadius(PixelFilter filter);

// The inverse of the filter's distribution function in one dimension: entry i is the offset from the centre,
// in pixels, below which a share i / (size - 1) of the filter lies. Empty for the box, whose inverse is
// linear.
std::vector<float> filterTable(PixelFilter filter);

}  // namespace lavaray
