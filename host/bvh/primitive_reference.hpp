#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "bvh/box.hpp"

namespace lavaray {

// gcc and clang turn each operation on the four numbers into vector instructions on any processor that has
// them, which they do not do reliably for loops over four floats.
using Float4 [[gnu::vector_size(16)]] = float;
using Int4 [[gnu::vector_size(16)]] = std::int32_t;

inline Float4 min(Float4 a, Float4 b) {
  return b < a ? b : a;
}
inline Float4 max(Float4 a, Float4 b) {
  return a < b ? b : a;
}

// A box for the builder's inner loops. The fourth numbers are padding and not part of the box.
struct PaddedBox {
  Float4 lower;
  Float4 upper;

  void extend(Float4 point) {
    lower = min(lower, point);
    upper = max(upper, point);
  }
  void extend(const PaddedBox& box) {
    lower = min(lower, box.lower);
    upper = max(upper, box.upper);
  }
  [[nodiscard]] Float4 doubledCentroid() const { return lower + upper; }
  [[nodiscard]] float doubledCentroid(int axis) const { return lower[axis] + upper[axis]; }
  [[nodiscard]] Box unpadded() const {
    return {{lower[0], lower[1], lower[2]}, {upper[0], upper[1], upper[2]}};
  }
};

// Neutral in a union.
inline PaddedBox emptyBox() {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr Float4 kInfinities{kInfinity, kInfinity, kInfinity, kInfinity};
  return {kInfinities, -kInfinities};
}

// Half the surface area of a box that is not empty.
inline float halfArea(const PaddedBox& box) {
  const Float4 size = box.upper - box.lower;
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

// A primitive reference, which the builder sorts in place of the primitive: its box, with the primitive's
// index in the padding. Read as a float, an index below 2^28 is finite.
struct Reference {
  PaddedBox box;

  [[nodiscard]] std::uint32_t primitive() const { return std::bit_cast<std::uint32_t>(box.upper[3]); }
};

inline Reference makeReference(const Box& box, std::uint32_t primitive) {
  return {{Float4{box.lower.x, box.lower.y, box.lower.z, 0.0F},
           Float4{box.upper.x, box.upper.y, box.upper.z, std::bit_cast<float>(primitive)}}};
}

}  // namespace lavaray
