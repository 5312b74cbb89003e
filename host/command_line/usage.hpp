#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "base/rectangle.hpp"

namespace lavaray {

// What the programs' command lines have in common.

// The option's value must be a number, or an integer, within these bounds; so NaN is none.
CLI::Validator numberFrom(double least, double most);
CLI::Validator numberFrom(double least);
CLI::Validator integerFrom(std::int64_t least, std::int64_t most);
CLI::Validator integerFrom(std::int64_t least);

// The option's value must name something; the second is for files that stdout does not stand for.
CLI::Validator fileName();
CLI::Validator fileNameNotStdout();

// Parses the command line. False where it asked for help or the version, which are printed then. Throws
// Error(kUsage).
bool parseCommandLine(CLI::App& app, int argc, const char* const* argv);

// The option --crop; `description` is its help.
void addCropOption(CLI::App& app, std::optional<Rectangle>& crop, const std::string& description);
// The crop, or all of an image of `size` where there is none. Throws Error(kUsage) where it is not inside.
Rectangle cropWithin(const std::optional<Rectangle>& crop, const ImageSize& size);

}  // namespace lavaray
