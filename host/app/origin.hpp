#pragma once

#include <optional>
#include <string>

#include "app/options.hpp"
#include "image/png_file.hpp"
#include "render/renderer.hpp"

namespace lavaray {

// What white stands for, where the picture shows a cost. Once it has been taken from its render.
std::optional<std::string> describeScale(View view, const RenderStatistics& result);

// What a picture file says of how it came to be.
TextEntries describeOrigin(const Options& options, const RenderSettings& settings,
                           const RenderStatistics& result, const std::string& device, double seconds);

}  // namespace lavaray
