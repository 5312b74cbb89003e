#pragma once

#include <vector>

namespace lavaray {

// Weights of a filter along a line, an odd number of them.
using Kernel = std::vector<float>;

inline int radius(const Kernel& kernel) {
  return static_cast<int>(kernel.size() / 2);
}

// A filter of two dimensions that is a product of two of one.
struct SeparableKernel {
  Kernel across;
  Kernel down;
};

// The filters of FLIP (see flip.hpp). The contrast sensitivity of the eye blurs an image as it is seen from
// the distance, each opponent channel in its own way; that of blue against yellow is the sum of two products.
// Edges and points are found by the first and the second derivative of a Gaussian along one axis and a smooth
// one along the other.
struct FlipFilters {
  SeparableKernel achromatic;
  SeparableKernel redGreen;
  SeparableKernel blueYellowWide;
  SeparableKernel blueYellowNarrow;
  Kernel edge;    // its positive and its negative weights add up to 1 and -1
  Kernel point;   // likewise
  Kernel smooth;  // adds up to 1
  int maxRadius = 0;
};

FlipFilters flipFilters(double pixelsPerDegree);

}  // namespace lavaray
