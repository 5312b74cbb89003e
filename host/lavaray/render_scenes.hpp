#pragma once

#include <vector>

#include "lavaray/options.hpp"

namespace lavaray {

// Renders the scenes to their files, one after the other, on one device. If one of several fails it is named,
// and the others are still rendered; an interrupt ends them all. Returns, once all is written and the user
// has closed the window of --display, the first failure's exit code, or 0.
int renderScenes(const std::vector<Options>& scenes);

}  // namespace lavaray
