#pragma once

#include <vector>

#include "lavaray/options.hpp"

namespace lavaray {

// Finds out, before anything is done, where a file that one of the scenes is to be written to is one that
// another reads or writes, and throws Error(kUsage) there.
void checkFiles(const std::vector<Options>& scenes);

}  // namespace lavaray
