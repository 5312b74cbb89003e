#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "bvh/range.hpp"

namespace lavaray {

// Finds splits by binning. Based on: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies",
// 2007.

constexpr int kMaxBins = 32;

// Maps a box's doubled centroid to one of `bins` bins, which divide the extent of a range's centroids
// evenly along each axis. An axis with no extent, or one too small to divide by, has scale 0.
struct BinMapping {
  int bins;
  Float4 lower;
  Float4 scale;

  explicit BinMapping(const Range& range);
  [[nodiscard]] bool canSplit(int axis) const { return scale[axis] > 0.0F; }
  [[nodiscard]] int bin(const PaddedBox& box, int axis) const {
    return static_cast<int>((box.doubledCentroid(axis) - lower[axis]) * scale[axis]);
  }
  // On the three axes; the fourth number is 0.
  [[nodiscard]] Int4 bin(const PaddedBox& box) const {
    return __builtin_convertvector((box.doubledCentroid() - lower) * scale, Int4);
  }
};

// The number of references in each bin of each axis, and their bounding boxes.
struct Bins {
  int size;  // bins per axis
  PaddedBox boxes[3][kMaxBins];
  std::uint32_t counts[3][kMaxBins];

  explicit Bins(int binsPerAxis);
  void add(std::span<const Reference> references, const BinMapping& mapping);
  void add(const Bins& other);
  [[nodiscard]] PaddedBox boxOf(int axis, int first, int last) const;
};

struct BinSplit {
  int axis;
  int lastLeftBin;
};

// The split that costs least by the surface area heuristic; empty if all centroids coincide.
std::optional<BinSplit> bestSplit(const Bins& bins, const BinMapping& mapping);

}  // namespace lavaray
