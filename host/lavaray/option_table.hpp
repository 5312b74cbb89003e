#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "lavaray/options.hpp"

namespace lavaray {

// Every option of the program, in the order of its help, each written to its place in `options`. What an
// option holds already is its default.
void addOptions(CLI::App& app, Options& options, std::vector<std::string>& scenes);

}  // namespace lavaray
