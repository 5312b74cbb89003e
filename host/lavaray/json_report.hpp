#pragma once

#include <cstdio>

#include "lavaray/run_report.hpp"

namespace lavaray {

// One JSON object each; docs/command-line.md has its schema. Whether all of it was written is for the owner
// of the stream to check.

// What --check says, and the size of the whole picture.
void writeJsonCheck(std::FILE* stream, const SceneSummary& scene, const ImageSize& picture);

// What --stats says.
void writeJsonReport(std::FILE* stream, const RunReport& report);

}  // namespace lavaray
