#pragma once

#include "app/options.hpp"
#include "core/errors.hpp"

namespace lavaray {

// Renders the scene to its files. Returns when the picture is written, and the user has closed the window of
// --display.
ExitCode renderScene(const Options& options);

}  // namespace lavaray
