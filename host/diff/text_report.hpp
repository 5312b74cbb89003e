#pragma once

#include <lavaray/image.h>
#include <vector>

namespace lavaray {

bool isCompared(const ComparedPair& compared);

// What is printed to stdout.

// All that is known of one pair, in several lines. Nothing if it cannot be read.
void printPair(const ComparedPair& compared);

// One of many pairs, in a line; and at the end how many are what.
void printLine(const ComparedPair& compared);
void printSummary(const std::vector<Verdict>& verdicts);

}  // namespace lavaray
