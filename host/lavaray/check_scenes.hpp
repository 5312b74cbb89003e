#pragma once

#include <vector>

#include "lavaray/options.hpp"

namespace lavaray {

// --check: reads the scenes and says what is in them. Returns the first failure's exit code, or 0.
int checkScenes(const std::vector<Options>& scenes);

}  // namespace lavaray
