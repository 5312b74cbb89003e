#pragma once

#include <cstdint>
#include <span>

#include "bvh/bvh.hpp"
#include "bvh/range.hpp"

namespace lavaray {

// Roughly where trying every split becomes slower than binning.
constexpr std::uint32_t kMaxSweepSize = 32;

// Builds the subtree of a range of at most kMaxSweepSize primitives, given their references; the range's
// bounds are not read. Sorts the references by centroid on each axis and tries every split. Returns the index
// after the subtree's last node. Based on: Wald, Boulos and Shirley, "Ray Tracing Deformable Scenes using
// Dynamic Bounding Volume Hierarchies", 2007.
std::uint32_t buildBySweep(std::span<const Reference> references, const Range& range, Bvh& bvh);

}  // namespace lavaray
