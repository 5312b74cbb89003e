#include "measure.hpp"

#include <algorithm>
#include <ctime>

namespace lavaray::bench {
namespace {

double now(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

std::vector<Timing> measure(const std::vector<Contestant>& contestants, int rounds) {
  std::vector<Timing> timings;
  for (const Contestant& contestant : contestants) {
    timings.push_back({contestant.name, {}, {}});
    contestant.run();
  }
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const double wall = now(CLOCK_MONOTONIC);
      const double cpu = now(CLOCK_PROCESS_CPUTIME_ID);
      contestants[i].run();
      timings[i].cpu.push_back(now(CLOCK_PROCESS_CPUTIME_ID) - cpu);
      timings[i].wall.push_back(now(CLOCK_MONOTONIC) - wall);
    }
  }
  return timings;
}

double minimum(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace lavaray::bench
