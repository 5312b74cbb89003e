#pragma once

#include <vector>

#include "app/options.hpp"
#include "core/errors.hpp"

namespace lavaray {

// Reads the scenes and says what is in them: --check. Returns the first failure's exit code.
ExitCode checkScenes(const std::vector<Options>& scenes);

}  // namespace lavaray
