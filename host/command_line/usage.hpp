#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <lavaray/types.h>
#include <CLI/CLI.hpp>

namespace lavaray {

// What the command lines of the programs have in common.

// The option's value must be a number, or an integer, within these bounds; NaN is not.
CLI::Validator numberFrom(double min, double max);
CLI::Validator numberFrom(double min);
CLI::Validator integerFrom(std::int64_t min, std::int64_t max);
CLI::Validator integerFrom(std::int64_t min);

// The option's value must not be empty; nor, for the second, `-`, which is stdout.
CLI::Validator fileName();
CLI::Validator fileNameNotStdout();

// Parses the command line. False if it asked for help or the version, which have been printed then. Throws
// Error(kUsage).
bool parseCommandLine(CLI::App& app, int argc, const char* const* argv);

// The option --crop; `description` is its help.
void addCropOption(CLI::App& app, std::optional<v0::Rectangle>& crop, const std::string& description);

}  // namespace lavaray
