#pragma once

#include <functional>
#include <string>
#include <vector>

namespace lavaray::bench {

// One of several ways to do the same work.
struct Contestant {
  std::string name;
  std::function<void()> run;
};

// Times in seconds, one per round.
struct Timing {
  std::string name;
  std::vector<double> cpu;  // of all threads of the process
  std::vector<double> wall;
};

// After a round that is not counted, runs each contestant once per round, in turns, so that whatever else
// happens on the machine affects all of them.
std::vector<Timing> measure(const std::vector<Contestant>& contestants, int rounds);

double minimum(const std::vector<double>& values);
double median(std::vector<double> values);

}  // namespace lavaray::bench
