#pragma once

#include "base/errors.hpp"
#include "lavaray/options.hpp"

namespace lavaray {

// Renders the scene to its files, and again whenever a file that it is made of changes, until the user
// interrupts the program or closes the window.
ExitCode watchScene(const Options& options);

}  // namespace lavaray
