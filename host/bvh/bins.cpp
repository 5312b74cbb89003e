#include "bvh/bins.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lavaray {
namespace {

// Few primitives need few bins. With fewer than these the tree costs up to 1% more; beyond kMaxBins it costs
// hardly less.
int binsFor(std::uint32_t primitives) {
  return static_cast<int>(std::min<std::uint32_t>(kMaxBins, 8 + primitives / 8));
}

}  // namespace

BinMapping::BinMapping(const Range& range)
    : bins(binsFor(range.count)), lower(range.bounds.centroids.lower), scale{} {
  // Just short of the last bin's end, so that the largest centroid lands in the last bin however it is
  // rounded.
  const float end = static_cast<float>(bins) * (1.0F - 0x1p-20F);
  const PaddedBox& centroids = range.bounds.centroids;
  for (int axis = 0; axis < 3; ++axis) {
    const float quotient = end / (centroids.upper[axis] - centroids.lower[axis]);
    scale[axis] = std::isfinite(quotient) ? quotient : 0.0F;
  }
}

Bins::Bins(int binsPerAxis) : size(binsPerAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    std::fill_n(boxes[axis], size, emptyBox());
    std::fill_n(counts[axis], size, 0U);
  }
}

void Bins::add(std::span<const Reference> references, const BinMapping& mapping) {
  for (const Reference& reference : references) {
    const PaddedBox box = reference.box;
    const Int4 bin = mapping.bin(box);
    for (int axis = 0; axis < 3; ++axis) {
      boxes[axis][bin[axis]].extend(box);
      ++counts[axis][bin[axis]];
    }
  }
}

void Bins::add(const Bins& other) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int bin = 0; bin < size; ++bin) {
      boxes[axis][bin].extend(other.boxes[axis][bin]);
      counts[axis][bin] += other.counts[axis][bin];
    }
  }
}

PaddedBox Bins::boxOf(int axis, int first, int last) const {
  PaddedBox box = emptyBox();
  for (int bin = first; bin <= last; ++bin) box.extend(boxes[axis][bin]);
  return box;
}

std::optional<BinSplit> bestSplit(const Bins& bins, const BinMapping& mapping) {
  std::optional<BinSplit> best;
  float bestCost = 0.0F;  // half area times primitives, summed over both sides
  for (int axis = 0; axis < 3; ++axis) {
    if (!mapping.canSplit(axis)) continue;
    // Neither side of a split is ever empty, since neither the first bin nor the last one is.
    std::array<float, kMaxBins> rightCost;
    PaddedBox right = emptyBox();
    int rightCount = 0;
    for (int i = bins.size - 1; i > 0; --i) {
      right.extend(bins.boxes[axis][i]);
      rightCount += static_cast<int>(bins.counts[axis][i]);
      rightCost[i] = halfArea(right) * static_cast<float>(rightCount);
    }
    PaddedBox left = emptyBox();
    int leftCount = 0;
    for (int i = 0; i + 1 < bins.size; ++i) {
      left.extend(bins.boxes[axis][i]);
      leftCount += static_cast<int>(bins.counts[axis][i]);
      const float cost = halfArea(left) * static_cast<float>(leftCount) + rightCost[i + 1];
      if (!best || cost < bestCost) {
        best = BinSplit{axis, i};
        bestCost = cost;
      }
    }
  }
  return best;
}

}  // namespace lavaray
