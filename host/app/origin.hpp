#pragma once

#include <string>

#include "app/options.hpp"
#include "image/png_file.hpp"
#include "render/renderer.hpp"

namespace lavaray {

// What a picture file says of how it came to be.
TextEntries describeOrigin(const Options& options, const RenderSettings& settings,
                           const RenderStatistics& result, const std::string& device, double seconds);

}  // namespace lavaray
