#pragma once

#include <cstdint>
#include <vector>

#include "bvh/gpu_scene.hpp"
#include "render/settings.hpp"

namespace lavaray {

// The pixels of the crop, by index, that objects cover whose projection is less than two pixels wide or high:
// a few samples can miss such an object, and so can its neighbours' samples. Each pixel is named once.
// Objects seen
// only in mirrors or by their shadows are not looked for.
std::vector<std::uint64_t> pixelsOfSmallObjects(const GpuScene& scene, const RenderSettings& settings);

}  // namespace lavaray
