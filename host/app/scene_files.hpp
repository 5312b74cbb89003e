#pragma once

#include <vector>

#include "app/options.hpp"

namespace lavaray {

// Finds out, before anything is done, where a file that one of the scenes is to be written to is one that
// another reads or writes, and throws Error(kUsage) there. For a single scene also what else would make
// writing fail, as checkOutputs does; of several, one that cannot be written must not keep the others from
// being.
void checkFiles(const std::vector<Options>& scenes);

}  // namespace lavaray
