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

// Half the surface areas of three boxes that are not empty, each sum in the order of halfArea().
Float4 halfAreas(const std::array<PaddedBox, 3>& boxes) {
  const Float4 a = boxes[0].upper - boxes[0].lower;
  const Float4 b = boxes[1].upper - boxes[1].lower;
  const Float4 c = boxes[2].upper - boxes[2].lower;
  const Float4 low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Float4 high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Float4 x = __builtin_shufflevector(low, c, 0, 1, 4, 4);
  const Float4 y = __builtin_shufflevector(low, c, 2, 3, 5, 5);
  const Float4 z = __builtin_shufflevector(high, c, 0, 1, 6, 6);
  return x * y + y * z + z * x;
}

// All three axes are swept at once, each in a vector's element of its own.
class SweepBuilder {
 public:
  SweepBuilder(std::span<const Reference> references, const Range& range, Bvh& bvh)
      : references_(references), first_(range.first), nextNode_(range.node), bvh_(bvh) {
    sort();
  }

  // Builds the subtree of what is sorted to indices [begin, end); returns the index of its root.
  std::uint32_t build(int begin, int end, std::uint32_t depth) {
    const std::uint32_t index = nextNode_++;
    const auto count = static_cast<std::uint32_t>(end - begin);
    if (count == 1) {
      makeLeaf(index, at(0, begin).box, begin, end);
      return index;
    }
    PaddedBox box;
    SweepSplit best = count == 2 ? onlySplit(begin, box) : sweep(begin, end, box);
    const float area = halfArea(box);
    const float leafCost = static_cast<float>(count) * area;
    const bool anySplit = depthAllowsAnySplit(depth, count);
    if (count <= gpu::kMaxLeafSize && (!anySplit || area + best.cost >= leafCost)) {
      makeLeaf(index, box, begin, end);
    } else {
      // If no split gains anything, as among equal boxes, at least keep the tree shallow.
      if (!anySplit || best.cost >= leafCost) best.middle = (begin + end) / 2;
      partition(best, begin, end);
      build(begin, best.middle, depth + 1);
      const std::uint32_t right = build(best.middle, end, depth + 1);
      bvh_.nodes[index] = {box.unpadded(), 0, right};
    }
    return index;
  }

  [[nodiscard]] std::uint32_t nextNode() const { return nextNode_; }

 private:
  [[nodiscard]] const Reference& at(int axis, int index) const { return references_[sorted_[axis][index]]; }

  void makeLeaf(std::uint32_t index, const PaddedBox& box, int begin, int end) {
    const std::uint32_t first = first_ + static_cast<std::uint32_t>(begin);
    for (int i = begin; i < end; ++i) bvh_.order[first_ + i] = at(0, i).primitive();
    bvh_.nodes[index] = {box.unpadded(), static_cast<std::uint32_t>(end - begin), first};
  }

  // Puts each reference at the index that is the number of references before it. For so few, counting beats
  // comparing and swapping: no branch depends on the outcome of a comparison.
  void sort() {
    const int count = static_cast<int>(references_.size());
    std::array<Float4, kMaxSweepSize> keys;
    for (int i = 0; i < count; ++i) keys[i] = references_[i].box.doubledCentroid();
    for (int i = 0; i < count; ++i) {
      Int4 index{};
      for (int j = 0; j < i; ++j) index -= keys[j] <= keys[i];
      for (int j = i + 1; j < count; ++j) index -= keys[j] < keys[i];
      for (int axis = 0; axis < 3; ++axis) sorted_[axis][index[axis]] = static_cast<std::uint8_t>(i);
    }
  }

  // Of two primitives. `box` becomes that of both.
  SweepSplit onlySplit(int begin, PaddedBox& box) const {
    const PaddedBox& left = at(0, begin).box;
    const PaddedBox& right = at(0, begin + 1).box;
    box = left;
    box.extend(right);
    return {halfArea(left) + halfArea(right), 0, begin + 1};
  }

  // The split that costs least. `box` becomes that of all references.
  SweepSplit sweep(int begin, int end, PaddedBox& box) const {
    std::array<Float4, kMaxSweepSize> rightCosts;
    std::array<PaddedBox, 3> boxes{emptyBox(), emptyBox(), emptyBox()};
    for (int i = end - 1; i > begin; --i) {
      for (int axis = 0; axis < 3; ++axis) boxes[axis].extend(at(axis, i).box);
      rightCosts[i] = halfAreas(boxes) * static_cast<float>(end - i);
    }
    for (int axis = 0; axis < 3; ++axis) boxes[axis] = at(axis, begin).box;
    Float4 leastCosts{kInfinity, kInfinity, kInfinity, kInfinity};
    Int4 middles{};
    for (int i = begin + 1; i < end; ++i) {
      const Float4 costs = halfAreas(boxes) * static_cast<float>(i - begin) + rightCosts[i];
      middles = costs < leastCosts ? Int4{i, i, i, i} : middles;
      leastCosts = costs < leastCosts ? costs : leastCosts;
      for (int axis = 0; axis < 3; ++axis) boxes[axis].extend(at(axis, i).box);
    }
    SweepSplit best;
    for (int axis = 0; axis < 3; ++axis) {
      if (leastCosts[axis] < best.cost) best = {leastCosts[axis], axis, middles[axis]};
    }
    box = boxes[2];
    return best;
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
