#pragma once

#include <vector>

#include "base/errors.hpp"
#include "lavaray/options.hpp"

namespace lavaray {

// --check: reads the scenes and says what is in them. Returns the first failure's exit code.
ExitCode checkScenes(const std::vector<Options>& scenes);

}  // namespace lavaray
