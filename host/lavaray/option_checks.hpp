#pragma once

#include "lavaray/options.hpp"

namespace lavaray {

// What options say of each other, each of which is fine by itself. Throw Error(kUsage).

// Of those that are the same for all scenes.
void checkViewAndError(const Options& options);
// Of those of one scene, whose output has its name.
void checkOptions(const Options& options);

}  // namespace lavaray
