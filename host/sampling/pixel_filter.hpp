#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lavaray {

// Reconstruction filters, separable; sampled by importance, so that every sample has the same weight.
enum class PixelFilter {
  kBox,             // the pixel itself
  kTent,            // to 1 pixel from the centre
  kGaussian,        // standard deviation 1/2 pixel, to 1.5 pixels
  kBlackmanHarris,  // to 1.5 pixels
};

inline constexpr const char* kPixelFilterNames = "box, tent, gaussian, blackman-harris";

std::optional<PixelFilter> pixelFilter(const std::string& name);
std::string pixelFilterName(PixelFilter filter);

// The largest offset from the pixel's centre, in pixels.
double filterRadius(PixelFilter filter);

// The inverse of the filter's distribution function in one dimension: entry i is the offset from the centre,
// in pixels, below which a share i / (size - 1) of the filter lies. Empty for the box, whose inverse is
// linear.
std::vector<float> filterTable(PixelFilter filter);

}  // namespace lavaray
