#pragma once

#include <lavaray/renderer.h>

#include <optional>
#include <string>

#include "lavaray/options.hpp"

namespace lavaray {

// What white stands for, if the picture shows a cost.
std::optional<std::string> describeScale(View view, const Statistics& result);

// What a picture file says of how it was made: what is known before the render, and what after it.
TextEntries describeOrigin(const Options& options, const ImageSize& size, const std::string& device);
TextEntries describeOutcome(View view, const Statistics& result, double seconds);

}  // namespace lavaray
