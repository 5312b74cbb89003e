#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace lavaray {

// What CLI11's table of the program's options says. The words are the same with every version of CLI11,
// unlike those of its own help.

// What --help prints: lines of at most 80 columns.
std::string helpText(CLI::App& app);

// What --help-table prints, for the programs that make the manual and the completion: a line each for the
// program, its purpose, its usage, each argument and option, and the closing words. Tabs separate the fields;
// an empty one is `-`:
//   program  NAME
//   purpose  SENTENCE
//   usage    what follows the program's name
//   argument NAME  what it takes  -  SENTENCES
//   option   NAMES what it takes  what is allowed  SENTENCES
//   footer   SENTENCES
std::string helpTable(CLI::App& app);

}  // namespace lavaray
