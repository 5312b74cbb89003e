#include "bvh/bvh.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <numeric>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "bvh/bins.hpp"
#include "bvh/range.hpp"
#include "bvh/sweep.hpp"
#include "interface.h"

namespace lavaray {
namespace {

// Larger ranges are split level by level, each level by all threads together; the subtree of a smaller one is
// a single thread's work. Ranges are scanned in chunks of a fixed size. Neither size depends on the number of
// threads, and boxes and counts add up to the same in any order, so the tree does not depend on it either.
constexpr std::uint32_t kSubtreeSize = 8192;
constexpr std::uint32_t kChunkSize = 16384;
// Only sweeps make leaves, and only within subtrees.
static_assert(gpu::kMaxLeafSize <= kMaxSweepSize && kMaxSweepSize <= kSubtreeSize);

struct Chunk {
  std::size_t range;  // index of the range it belongs to
  std::uint32_t first;
  std::uint32_t count;
};

std::vector<Chunk> chunksOf(std::span<const Range> ranges) {
  std::vector<Chunk> chunks;
  for (std::size_t r = 0; r < ranges.size(); ++r) {
    for (std::uint32_t begin = 0; begin < ranges[r].count; begin += kChunkSize) {
      chunks.push_back({r, ranges[r].first + begin, std::min(kChunkSize, ranges[r].count - begin)});
    }
  }
  return chunks;
}

// Orders a range's references by centroid on the axis of their largest extent, or by size if all centroids
// coincide; ties are broken by index, so that the order is total.
struct Order {
  int axis;
  bool isBySize;

  explicit Order(const PaddedBox& centroids) {
    const Float4 size = centroids.upper - centroids.lower;
    axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : (size[1] >= size[2] ? 1 : 2);
    isBySize = size[axis] == 0.0F;
  }
  [[nodiscard]] std::pair<float, std::uint32_t> key(const Reference& reference) const {
    const PaddedBox& box = reference.box;
    return {isBySize ? halfArea(box) : box.doubledCentroid(axis), reference.primitive()};
  }
  bool operator()(const Reference& a, const Reference& b) const { return key(a) < key(b); }
};

class Builder {
 public:
  Builder(std::size_t primitives, unsigned threads) : threads_(threads), references_(primitives) {
    bvh_.nodes.resize(2 * primitives - 1);
    bvh_.order.resize(primitives);
  }

  Bvh build(const std::function<Box(std::uint32_t)>& boxOf) {
    std::vector<Range> level{makeReferences(boxOf)};
    std::vector<Range> subtrees;
    while (!level.empty()) {
      const auto large = std::partition(level.begin(), level.end(),
                                        [](const Range& range) { return range.count <= kSubtreeSize; });
      subtrees.insert(subtrees.end(), level.begin(), large);
      level = splitAll({large, level.end()});
    }
    parallelFor(subtrees.size(), threads_, [&](std::size_t i) { buildSubtree(subtrees[i]); });
    bvh_.largestCoincidentGroup = largestCoincidentGroup_;
    return std::move(bvh_);
  }

 private:
  // Returns the range of all references.
  Range makeReferences(const std::function<Box(std::uint32_t)>& boxOf) {
    Range all{0, 0, static_cast<std::uint32_t>(references_.size()), 0, {}};
    const std::vector<Chunk> chunks = chunksOf(std::span(&all, 1));
    std::vector<Bounds> bounds(chunks.size());
    parallelFor(chunks.size(), threads_, [&](std::size_t c) {
      for (std::uint32_t i = chunks[c].first; i < chunks[c].first + chunks[c].count; ++i) {
        references_[i] = makeReference(boxOf(i), i);
        bounds[c].extend(references_[i]);
      }
    });
    for (const Bounds& part : bounds) all.bounds.extend(part);
    return all;
  }

  [[nodiscard]] std::span<Reference> references(std::uint32_t first, std::uint32_t count) {
    return std::span(references_).subspan(first, count);
  }

  // Makes an inner node of each range and returns their children.
  std::vector<Range> splitAll(std::span<const Range> ranges) {
    const std::vector<Chunk> chunks = chunksOf(ranges);
    const std::vector<BinMapping> mappings(ranges.begin(), ranges.end());
    std::vector<Bins> parts(chunks.size(), Bins(kMaxBins));
    parallelFor(chunks.size(), threads_, [&](std::size_t c) {
      parts[c].add(references(chunks[c].first, chunks[c].count), mappings[chunks[c].range]);
    });
    std::vector<Bins> bins(ranges.size(), Bins(kMaxBins));
    for (std::size_t c = 0; c < chunks.size(); ++c) bins[chunks[c].range].add(parts[c]);

    std::vector<Range> children(2 * ranges.size());
    parallelFor(ranges.size(), threads_, [&](std::size_t r) {
      const auto [left, right] = split(ranges[r], mappings[r], bins[r]);
      makeInnerNode(ranges[r], right.node);
      children[2 * r] = left;
      children[2 * r + 1] = right;
    });
    const std::vector<Chunk> childChunks = chunksOf(children);
    std::vector<PaddedBox> centroids(childChunks.size());
    parallelFor(childChunks.size(), threads_, [&](std::size_t c) {
      centroids[c] = centroidsOf(childChunks[c].first, childChunks[c].count);
    });
    for (std::size_t c = 0; c < childChunks.size(); ++c) {
      children[childChunks[c].range].bounds.centroids.extend(centroids[c]);
    }
    return children;
  }

  // Returns the index after the subtree's last node.
  std::uint32_t buildSubtree(const Range& range) {
    if (range.count <= kMaxSweepSize) return sweepSubtree(range);
    const BinMapping mapping(range);
    Bins bins(mapping.bins);
    bins.add(references(range.first, range.count), mapping);
    auto [left, right] = split(range, mapping, bins);
    left.bounds.centroids = centroidsOf(left.first, left.count);
    right.bounds.centroids = centroidsOf(right.first, right.count);
    right.node = buildSubtree(left);  // leaves no gap after the left subtree, whose size is known now
    makeInnerNode(range, right.node);
    return buildSubtree(right);
  }

  std::uint32_t sweepSubtree(const Range& range) {
    const std::span<Reference> all = references(range.first, range.count);
    // Sweeping keeps references with the same centroid in order.
    const Order order(range.bounds.centroids);
    if (order.isBySize) std::sort(all.begin(), all.end(), order);
    return buildBySweep(all, range, bvh_);
  }

  void makeInnerNode(const Range& range, std::uint32_t right) {
    bvh_.nodes[range.node] = {range.bounds.box.unpadded(), 0, right};
  }

  PaddedBox centroidsOf(std::uint32_t first, std::uint32_t count) {
    PaddedBox centroids = emptyBox();
    for (const Reference& reference : references(first, count)) {
      centroids.extend(reference.box.doubledCentroid());
    }
    return centroids;
  }

  // Both parts, without the bounds of their centroids.
  std::array<Range, 2> split(const Range& range, const BinMapping& mapping, const Bins& bins) {
    const std::optional<BinSplit> best = bestSplit(bins, mapping);
    if (best && depthAllowsAnySplit(range.depth, range.count)) return splitAtBin(range, mapping, bins, *best);
    return splitAtMedian(range);
  }

  // Uses Lomuto's partition: its loop has no branch to mispredict.
  std::array<Range, 2> splitAtBin(const Range& range, const BinMapping& mapping, const Bins& bins,
                                  const BinSplit& split) {
    const std::span<Reference> all = references(range.first, range.count);
    std::uint32_t leftCount = 0;
    for (Reference& reference : all) {
      const bool isLeft = mapping.bin(reference.box, split.axis) <= split.lastLeftBin;
      std::swap(reference, all[leftCount]);
      leftCount += isLeft ? 1 : 0;
    }
    std::array<Range, 2> children = childrenOf(range, leftCount);
    children[0].bounds.box = bins.boxOf(split.axis, 0, split.lastLeftBin);
    children[1].bounds.box = bins.boxOf(split.axis, split.lastLeftBin + 1, bins.size - 1);
    return children;
  }

  std::array<Range, 2> splitAtMedian(const Range& range) {
    const Order order(range.bounds.centroids);
    if (order.isBySize) noteCoincidentGroup(range.count);
    const std::span<Reference> all = references(range.first, range.count);
    std::nth_element(all.begin(), all.begin() + range.count / 2, all.end(), order);
    std::array<Range, 2> children = childrenOf(range, range.count / 2);
    for (Range& child : children) {
      for (const Reference& reference : references(child.first, child.count)) {
        child.bounds.box.extend(reference.box);
      }
    }
    return children;
  }

  // The two parts of a range, their bounds still unset. The right part's nodes start where even the largest
  // possible tree of the left part would end.
  static std::array<Range, 2> childrenOf(const Range& range, std::uint32_t leftCount) {
    const std::uint32_t rightCount = range.count - leftCount;
    return {{{range.node + 1, range.first, leftCount, range.depth + 1, {}},
             {range.node + 2 * leftCount, range.first + leftCount, rightCount, range.depth + 1, {}}}};
  }

  void noteCoincidentGroup(std::uint32_t count) {
    std::uint32_t known = largestCoincidentGroup_;
    while (known < count && !largestCoincidentGroup_.compare_exchange_weak(known, count)) {
    }
  }

  unsigned threads_;
  Bvh bvh_;
  UninitializedVector<Reference> references_;
  std::atomic<std::uint32_t> largestCoincidentGroup_{0};
};

void measureNode(const Bvh& bvh, std::uint32_t index, unsigned depth, double rootArea, BvhQuality& quality) {
  const BvhNode& node = bvh.nodes[index];
  // A root without area is hit whenever its contents are.
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
  measureNode(bvh, index + 1, depth + 1, rootArea, quality);
  measureNode(bvh, node.first, depth + 1, rootArea, quality);
}

}  // namespace

Bvh buildBvh(std::uint32_t count, const std::function<Box(std::uint32_t)>& boxOf, unsigned threads) {
  assert(count > 0 && count <= gpu::kMaxReference);
  return Builder(count, threads).build(boxOf);
}

Bvh buildBvh(std::span<const Box> boxes, unsigned threads) {
  return buildBvh(
      static_cast<std::uint32_t>(boxes.size()), [&](std::uint32_t i) { return boxes[i]; }, threads);
}

Bvh oneLeaf(std::span<const Box> boxes) {
  assert(!boxes.empty() && boxes.size() <= gpu::kMaxLeafSize);
  Bvh bvh;
  bvh.nodes.resize(1);
  bvh.nodes[0] = {{}, static_cast<std::uint32_t>(boxes.size()), 0};
  bvh.order.resize(boxes.size());
  std::iota(bvh.order.begin(), bvh.order.end(), 0U);
  for (const Box& box : boxes) bvh.nodes[0].box.extend(box);
  return bvh;
}

BvhQuality measure(const Bvh& bvh) {
  BvhQuality quality;
  measureNode(bvh, 0, 0, static_cast<double>(halfArea(bvh.nodes[0].box)), quality);
  quality.leafSize /= static_cast<double>(quality.leaves);
  return quality;
}

}  // namespace lavaray
