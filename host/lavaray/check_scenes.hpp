#pragma once

#include <vector>

#include "base/errors.hpp"
#include "lavaray/options.hpp"

namespace lavaray {

// Reads the scenes and says what is in them: --check. Returns the first failure's exit code.
ExitCode checkScenes(const std::vector<Options>& scenes);

}  // namespace lavaray
