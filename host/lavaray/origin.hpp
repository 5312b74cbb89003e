#pragma once

#include <optional>
#include <string>

#include "image/image.hpp"
#include "lavaray/options.hpp"
#include "render/render.hpp"

namespace lavaray {

// What white stands for, if the picture shows a cost.
std::optional<std::string> describeScale(View view, const RenderStatistics& result);

// What a picture file says of how it was made: what is known before the render, and what after it.
TextEntries describeOrigin(const Options& options, const RenderSettings& settings, const std::string& device);
TextEntries describeOutcome(View view, const RenderStatistics& result, double seconds);

}  // namespace lavaray
