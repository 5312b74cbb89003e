#pragma once

#include <vector>

#include "lavaray/options.hpp"

namespace lavaray {

// Before anything is done, throws Error(kUsage) if a file that one of the scenes would write is one that
// another reads or writes.
void checkFiles(const std::vector<Options>& scenes);

}  // namespace lavaray
