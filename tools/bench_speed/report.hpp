#pragma once

#include <iosfwd>

#include "results.hpp"

namespace lavaray::bench {

// What was measured on which machine, in words.
void printHead(std::ostream& out, const Results& results);
void printScene(std::ostream& out, const SceneResult& scene);
// Time per camera ray, build time and memory of all scenes, side by side.
void printSummary(std::ostream& out, const Results& results);

// All times, one by one, in seconds.
void writeJson(std::ostream& out, const Results& results);

}  // namespace lavaray::bench
