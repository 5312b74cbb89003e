#pragma once

#include <vector>

namespace lavaray {

// The weights of a one-dimensional filter; their number is odd.
using Kernel = std::vector<float>;

inline int radius(const Kernel& kernel) {
  return static_cast<int>(kernel.size() / 2);
}

// A two-dimensional filter that is the product of two one-dimensional ones.
struct SeparableKernel {
  Kernel across;
  Kernel down;
};

// The filters of FLIP (see flip.hpp). The eye's contrast sensitivity blurs an image seen from a distance,
// each opponent channel in its own way; the blur of blue against yellow is a sum of two products. Edges and
// points are found by the first and second derivatives of a Gaussian along one axis, with a plain Gaussian
// along the other.
struct FlipFilters {
  SeparableKernel achromatic;
  SeparableKernel redGreen;
  SeparableKernel blueYellowWide;
  SeparableKernel blueYellowNarrow;
  Kernel edge;    // its positive weights add up to 1, its negative ones to -1
  Kernel point;   // likewise
  Kernel smooth;  // adds up to 1
  int maxRadius = 0;
};

FlipFilters flipFilters(double pixelsPerDegree);

}  // namespace lavaray
