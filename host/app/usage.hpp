#pragma once

#include <cstdint>
#include <string>

#include <CLI/CLI.hpp>

#include "core/errors.hpp"

namespace lavaray {

// What the programs' command lines have in common.

// The option's value must be a number, or an integer, within these bounds; so NaN is none.
CLI::Validator numberFrom(double least, double most);
CLI::Validator numberFrom(double least);
CLI::Validator integerFrom(std::int64_t least, std::int64_t most);
CLI::Validator integerFrom(std::int64_t least);

// What is wrong with a command line, in the words that the programs use.
Error usageError(const CLI::ParseError& error, const std::string& program);

}  // namespace lavaray
