#pragma once

#include <cstdint>
#include <vector>

#include "bvh/flatten.hpp"
#include "render/settings.hpp"

namespace lavaray {

// The pixels of the crop, by index, onto which objects fall whose image is less than two pixels wide or high:
// a few samples can miss such an object, and its neighbours' samples with them. Each pixel is named once.
// Objects in mirrors and shadows are not looked for.
std::vector<std::uint64_t> pixelsOfSmallObjects(const GpuScene& scene, const Camera& camera,
                                                const RenderSettings& settings);

}  // namespace lavaray
