#include "bvh/sweep.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "interface.h"

namespace lavaray {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct SweepSplit {
  float cost = kInfinity;  // half area times primitives, summed over both sides
  int axis = 0;
  int middle = 0;  // first index of the right side
};

class SweepBuilder {
 public:
  SweepBuilder(std::span<const Reference> references, const Range& range, Bvh& bvh)
      : references_(references), first_(range.first), nextNode_(range.node), bvh_(bvh) {
    for (int axis = 0; axis < 3; ++axis) sort(axis);
  }

  // Builds the subtree of what is sorted to indices [begin, end); returns the index of its root.
  std::uint32_t build(int begin, int end, std::uint32_t depth) {
    const std::uint32_t index = nextNode_++;
    const auto count = static_cast<std::uint32_t>(end - begin);
    SweepSplit best;
    PaddedBox box;
    // Two primitives can be split in one way only.
    for (int axis = 0; axis < (count > 2 ? 3 : 1); ++axis) box = sweep(axis, begin, end, best);

    const float area = halfArea(box);
    const float leafCost = static_cast<float>(count) * area;
    const bool anySplit = depthAllowsAnySplit(depth, count);
    if (count <= gpu::kMaxLeafSize && (!anySplit || area + best.cost >= leafCost)) {
      const std::uint32_t first = first_ + static_cast<std::uint32_t>(begin);
      for (int i = begin; i < end; ++i) bvh_.order[first_ + i] = at(0, i).primitive();
      bvh_.nodes[index] = {box.unpadded(), count, first, 0, 0};
    } else {
      // If no split gains anything, as among equal boxes, at least keep the tree shallow.
      if (!anySplit || best.cost >= leafCost) best.middle = (begin + end) / 2;
      partition(best, begin, end);
      const std::uint32_t left = build(begin, best.middle, depth + 1);
      const std::uint32_t right = build(best.middle, end, depth + 1);
      bvh_.nodes[index] = {box.unpadded(), 0, 0, left, right};
    }
    return index;
  }

  [[nodiscard]] std::uint32_t nextNode() const { return nextNode_; }

 private:
  [[nodiscard]] const Reference& at(int axis, int index) const { return references_[sorted_[axis][index]]; }

  // Puts each reference at the index that is the number of references before it. For so few, counting beats
  // comparing and swapping: no branch depends on the outcome of a comparison.
  void sort(int axis) {
    const int count = static_cast<int>(references_.size());
    std::array<float, kMaxSweepSize> keys;
    for (int i = 0; i < count; ++i) keys[i] = references_[i].box.doubledCentroid(axis);
    for (int i = 0; i < count; ++i) {
      int index = 0;
      for (int j = 0; j < i; ++j) index += keys[j] <= keys[i] ? 1 : 0;
      for (int j = i + 1; j < count; ++j) index += keys[j] < keys[i] ? 1 : 0;
      sorted_[axis][index] = static_cast<std::uint8_t>(i);
    }
  }

  // Replaces `best` with the axis's best split if that costs less. Returns the box of all references.
  PaddedBox sweep(int axis, int begin, int end, SweepSplit& best) const {
    std::array<float, kMaxSweepSize> rightCost;
    PaddedBox right = emptyBox();
    for (int i = end - 1; i > begin; --i) {
      right.extend(at(axis, i).box);
      rightCost[i] = halfArea(right) * static_cast<float>(end - i);
    }
    PaddedBox left = at(axis, begin).box;
    for (int i = begin + 1; i < end; ++i) {
      const float cost = halfArea(left) * static_cast<float>(i - begin) + rightCost[i];
      if (cost < best.cost) best = {cost, axis, i};
      left.extend(at(axis, i).box);
    }
    return left;
  }

  // On the split's axis both sides are in place already. On the others this moves them there, each side
  // keeping its order.
  void partition(const SweepSplit& split, int begin, int end) {
    std::uint32_t isLeft = 0;  // bit i stands for references_[i]
    for (int i = begin; i < split.middle; ++i) isLeft |= 1U << sorted_[split.axis][i];
    for (int axis = 0; axis < 3; ++axis) {
      if (axis == split.axis) continue;
      auto& sorted = sorted_[axis];
      std::array<std::uint8_t, kMaxSweepSize> rights;
      std::uint32_t left = begin;
      std::uint32_t right = 0;
      for (int i = begin; i < end; ++i) {
        const std::uint8_t reference = sorted[i];
        const std::uint32_t goesLeft = isLeft >> reference & 1U;
        sorted[left] = rights[right] = reference;
        left += goesLeft;
        right += 1 - goesLeft;
      }
      std::copy_n(rights.begin(), right, sorted.begin() + left);
    }
  }

  std::span<const Reference> references_;
  std::uint32_t first_;
  std::uint32_t nextNode_;
  Bvh& bvh_;
  std::array<std::array<std::uint8_t, kMaxSweepSize>, 3> sorted_;  // on each axis, references_ by centroid
};

}  // namespace

std::uint32_t buildBySweep(std::span<const Reference> references, const Range& range, Bvh& bvh) {
  assert(references.size() == range.count && range.count <= kMaxSweepSize);
  SweepBuilder builder(references, range, bvh);
  builder.build(0, static_cast<int>(range.count), range.depth);
  return builder.nextNode();
}

}  // namespace lavaray
