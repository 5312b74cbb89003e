#pragma once

#include "lavaray/options.hpp"

namespace lavaray {

// Renders the scene to its files, and again whenever a file that it is made of changes, until the user
// interrupts the program or closes the window. Returns the exit code.
int watchScene(const Options& options);

}  // namespace lavaray
