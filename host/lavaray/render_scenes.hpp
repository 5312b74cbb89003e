#pragma once

#include <vector>

#include "base/errors.hpp"
#include "lavaray/options.hpp"

namespace lavaray {

// Renders the scenes to their files, one after the other on one device. Of several, one that fails is named,
// and the others are still rendered; an interrupt ends them all. Returns the first failure's exit code when
// all is written, and the user has closed the window of --display.
ExitCode renderScenes(const std::vector<Options>& scenes);

}  // namespace lavaray
