#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace lavaray {

// What the program's own table of options says, which is CLI11's. The words are the same with every version
// of CLI11, whose own help is not.

// What --help prints: lines of at most 80 columns.
std::string helpText(CLI::App& app);

// What --help-table prints, for other programs: the manual's maker and the completion. A line each for the
// program, its purpose, how it is used, each argument and option, and the closing words. Its fields end at
// tabs, and one that holds nothing is `-`:
//   program  NAME
//   purpose  SENTENCE
//   usage    what follows the program's name
//   argument NAME  what it takes  -  SENTENCES
//   option   NAMES what it takes  what is allowed  SENTENCES
//   footer   SENTENCES
std::string helpTable(CLI::App& app);

}  // namespace lavaray
