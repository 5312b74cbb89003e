#pragma once

#include "lavaray/options.hpp"

namespace lavaray {

// What the options of one scene say of each other, each of which is fine by itself. Throws Error(kUsage).
void checkOptions(const Options& options);

}  // namespace lavaray
