#pragma once

#include <functional>
#include <string>
#include <vector>

namespace lavaray::bench {

// One way to do a piece of work that several can do.
struct Contestant {
  std::string name;
  std::function<void()> run;
};

// Times in seconds, one a round.
struct Timing {
  std::string name;
  std::vector<double> cpu;  // of all threads of the process
  std::vector<double> wall;
};

// After one round that is not counted, lets each contestant run once a round, in turns, so that what else
// happens on the machine falls on all of them.
std::vector<Timing> measure(const std::vector<Contestant>& contestants, int rounds);

double least(const std::vector<double>& values);
double median(std::vector<double> values);

}  // namespace lavaray::bench
