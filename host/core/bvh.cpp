#include "core/bvh.hpp"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/parallel.hpp"
#include "interface.h"

namespace lavaray {
namespace {

constexpr int kBins = 32;
// Ranges above this size are split one after the other, each by all threads; below it a whole subtree is one
// thread's work. Ranges are scanned in chunks of a fixed size. Neither depends on the number of threads, and
// boxes and counts add up to the same in any order, so neither does the tree.
constexpr std::uint32_t kSubtreeSize = 8192;
constexpr std::uint32_t kChunkSize = 16384;

// order[first .. first + count - 1], to become the subtree whose root is `node` and whose nodes are among the
// 2 count - 1 from there on.
struct Range {
  std::uint32_t node;
  std::uint32_t first;
  std::uint32_t count;
  std::uint32_t depth;  // inner nodes above
};

struct Bounds {
  Box box;
  Box centroids;  // doubled

  void extend(const Bounds& other) {
    box.extend(other.box);
    centroids.extend(other.centroids);
  }
};

struct Bin {
  Box box;
  std::uint32_t count = 0;
};

using Bins = std::array<std::array<Bin, kBins>, 3>;

struct Split {
  int axis;
  int lastLeftBin;
  float cost;  // half area times primitives, summed over the two sides
};

// Maps doubled centroids to bins; an axis without extent, or with one too small to divide by, has scale 0.
class BinMapping {
 public:
  explicit BinMapping(const Box& centroids) : lower_(centroids.lower) {
    for (int axis = 0; axis < 3; ++axis) {
      const float scale = static_cast<float>(kBins) / (centroids.upper[axis] - centroids.lower[axis]);
      scale_[axis] = std::isfinite(scale) ? scale : 0.0F;
    }
  }
  [[nodiscard]] bool canSplit(int axis) const { return scale_[axis] > 0.0F; }
  [[nodiscard]] int bin(const glm::vec3& doubledCentroid, int axis) const {
    return std::min(kBins - 1, static_cast<int>((doubledCentroid[axis] - lower_[axis]) * scale_[axis]));
  }

 private:
  glm::vec3 lower_;
  glm::vec3 scale_{0.0F};
};

// Halvings that bring `count` primitives down to leaves.
std::uint32_t levelsNeeded(std::uint32_t count) {
  const std::uint32_t leaves = (count + gpu::kMaxLeafSize - 1) / gpu::kMaxLeafSize;
  return static_cast<std::uint32_t>(std::bit_width(leaves - 1));
}

class Builder {
 public:
  Builder(std::span<const Box> boxes, unsigned threads) : boxes_(boxes), threads_(threads) {
    bvh_.nodes.resize(2 * boxes.size() - 1);
    bvh_.order.resize(boxes.size());
    std::iota(bvh_.order.begin(), bvh_.order.end(), 0U);
  }

  Bvh build() {
    std::vector<Range> large{{0, 0, static_cast<std::uint32_t>(boxes_.size()), 0}};
    std::vector<Range> subtrees;
    while (!large.empty()) {
      const Range range = large.back();
      large.pop_back();
      if (range.count <= kSubtreeSize) {
        subtrees.push_back(range);
      } else if (const auto children = divide(range, threads_)) {
        large.insert(large.end(), children->begin(), children->end());
      }
    }
    parallelFor(subtrees.size(), threads_, [&](std::size_t i) { buildSubtree(subtrees[i]); });
    bvh_.largestCoincidentGroup = largestCoincidentGroup_;
    return std::move(bvh_);
  }

 private:
  void buildSubtree(const Range& range) {
    const auto children = divide(range, 1);
    if (!children) return;
    for (const Range& child : *children) buildSubtree(child);
  }

  // Makes the range's node: an inner node, whose children's ranges are returned, or a leaf.
  std::optional<std::array<Range, 2>> divide(const Range& range, unsigned threads) {
    const Bounds bounds = measureBounds(range, threads);
    BvhNode& node = bvh_.nodes[range.node];
    node.box = bounds.box;

    const BinMapping mapping(bounds.centroids);
    const std::optional<Split> split = range.count > 1 ? bestSplit(range, mapping, threads) : std::nullopt;
    const float area = halfArea(bounds.box);
    const bool splitPays = split && area + split->cost < static_cast<float>(range.count) * area;
    if (range.count <= gpu::kMaxLeafSize && (!splitPays || range.depth == gpu::kMaxBvhDepth)) {
      node.count = range.count;
      node.first = range.first;
      return std::nullopt;
    }

    const bool depthAllowsSah = range.depth + levelsNeeded(range.count) < gpu::kMaxBvhDepth;
    const std::uint32_t leftCount = split && depthAllowsSah ? partition(range, mapping, *split)
                                                            : partitionAtMedian(range, bounds.centroids);
    const Range left{range.node + 1, range.first, leftCount, range.depth + 1};
    const Range right{range.node + 2 * leftCount, range.first + leftCount, range.count - leftCount,
                      range.depth + 1};
    node.left = left.node;
    node.right = right.node;
    return std::array{left, right};
  }

  // Calls scan(begin, end, result) for each chunk of the range and adds the results up with merge(a, b).
  template <typename Result, typename Scan, typename Merge>
  Result scanChunks(const Range& range, unsigned threads, const Scan& scan, const Merge& merge) const {
    const std::size_t chunks = (range.count + kChunkSize - 1) / kChunkSize;
    std::vector<Result> results(chunks);
    parallelFor(chunks, threads, [&](std::size_t chunk) {
      const auto begin = static_cast<std::uint32_t>(range.first + chunk * kChunkSize);
      scan(begin, std::min(begin + kChunkSize, range.first + range.count), results[chunk]);
    });
    for (std::size_t chunk = 1; chunk < chunks; ++chunk) merge(results[0], results[chunk]);
    return results[0];
  }

  [[nodiscard]] Bounds measureBounds(const Range& range, unsigned threads) const {
    return scanChunks<Bounds>(
        range, threads,
        [&](std::uint32_t begin, std::uint32_t end, Bounds& bounds) {
          for (std::uint32_t i = begin; i < end; ++i) {
            const Box& box = boxes_[bvh_.order[i]];
            bounds.box.extend(box);
            bounds.centroids.extend(box.doubledCentroid());
          }
        },
        [](Bounds& sum, const Bounds& part) { sum.extend(part); });
  }

  [[nodiscard]] Bins fillBins(const Range& range, const BinMapping& mapping, unsigned threads) const {
    return scanChunks<Bins>(
        range, threads,
        [&](std::uint32_t begin, std::uint32_t end, Bins& bins) {
          for (std::uint32_t i = begin; i < end; ++i) {
            const Box& box = boxes_[bvh_.order[i]];
            const glm::vec3 centroid = box.doubledCentroid();
            for (int axis = 0; axis < 3; ++axis) {
              Bin& bin = bins[axis][mapping.bin(centroid, axis)];
              bin.box.extend(box);
              ++bin.count;
            }
          }
        },
        [](Bins& sum, const Bins& part) {
          for (int axis = 0; axis < 3; ++axis) {
            for (int bin = 0; bin < kBins; ++bin) {
              sum[axis][bin].box.extend(part[axis][bin].box);
              sum[axis][bin].count += part[axis][bin].count;
            }
          }
        });
  }

  // The split with the lowest cost that leaves neither side empty; nothing where all centroids coincide.
  [[nodiscard]] std::optional<Split> bestSplit(const Range& range, const BinMapping& mapping,
                                               unsigned threads) const {
    const Bins bins = fillBins(range, mapping, threads);
    std::optional<Split> best;
    for (int axis = 0; axis < 3; ++axis) {
      if (!mapping.canSplit(axis)) continue;
      std::array<float, kBins> rightCost{};
      Bin right;
      for (int i = kBins - 1; i > 0; --i) {
        right.box.extend(bins[axis][i].box);
        right.count += bins[axis][i].count;
        rightCost[i] = right.count > 0 ? halfArea(right.box) * static_cast<float>(right.count) : 0.0F;
      }
      Bin left;
      for (int i = 0; i + 1 < kBins; ++i) {
        left.box.extend(bins[axis][i].box);
        left.count += bins[axis][i].count;
        if (left.count == 0 || left.count == range.count) continue;
        const float cost = halfArea(left.box) * static_cast<float>(left.count) + rightCost[i + 1];
        if (!best || cost < best->cost) best = Split{axis, i, cost};
      }
    }
    return best;
  }

  // Both partitions return the number of primitives on the left.
  std::uint32_t partition(const Range& range, const BinMapping& mapping, const Split& split) {
    const auto begin = bvh_.order.begin() + range.first;
    const auto middle = std::partition(begin, begin + range.count, [&](std::uint32_t i) {
      return mapping.bin(boxes_[i].doubledCentroid(), split.axis) <= split.lastLeftBin;
    });
    return static_cast<std::uint32_t>(middle - begin);
  }

  std::uint32_t partitionAtMedian(const Range& range, const Box& centroids) {
    const glm::vec3 size = centroids.upper - centroids.lower;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    const bool coincident = size[axis] == 0.0F;
    if (coincident) noteCoincidentGroup(range.count);
    // Boxes about one centre are told apart by size, and equal ones by index, so that the order is total.
    const auto key = [&](std::uint32_t i) {
      return coincident ? halfArea(boxes_[i]) : boxes_[i].doubledCentroid()[axis];
    };
    const auto begin = bvh_.order.begin() + range.first;
    std::nth_element(
        begin, begin + range.count / 2, begin + range.count,
        [&](std::uint32_t a, std::uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
    return range.count / 2;
  }

  void noteCoincidentGroup(std::uint32_t count) {
    std::uint32_t known = largestCoincidentGroup_;
    while (known < count && !largestCoincidentGroup_.compare_exchange_weak(known, count)) {
    }
  }

  std::span<const Box> boxes_;
  unsigned threads_;
  Bvh bvh_;
  std::atomic<std::uint32_t> largestCoincidentGroup_{0};
};

void measureNode(const Bvh& bvh, std::uint32_t index, unsigned depth, double rootArea, BvhQuality& quality) {
  const BvhNode& node = bvh.nodes[index];
  // A root without area is hit as surely as its content.
  const double share = rootArea > 0.0 ? static_cast<double>(halfArea(node.box)) / rootArea : 1.0;
  quality.depth = std::max(quality.depth, depth);
  if (node.count > 0) {
    ++quality.leaves;
    quality.sahCost += share * node.count;
    quality.leafSize += node.count;
    return;
  }
  ++quality.innerNodes;
  quality.sahCost += share;
  measureNode(bvh, node.left, depth + 1, rootArea, quality);
  measureNode(bvh, node.right, depth + 1, rootArea, quality);
}

}  // namespace

Bvh buildBvh(std::span<const Box> boxes, unsigned threads) {
  assert(!boxes.empty() && boxes.size() <= gpu::kMaxReference);
  return Builder(boxes, threads).build();
}

BvhQuality measure(const Bvh& bvh) {
  BvhQuality quality;
  measureNode(bvh, 0, 0, static_cast<double>(halfArea(bvh.nodes[0].box)), quality);
  quality.leafSize /= static_cast<double>(quality.leaves);
  return quality;
}

}  // namespace lavaray
