#include "lavaray/run_report.hpp"

#include <sys/resource.h>

namespace lavaray {

RayRates ratesOf(const Statistics& render) {
  const double seconds = render.activity.seconds;
  const auto rate = [&](std::uint64_t rays) {
    return seconds > 0.0 ? static_cast<double>(rays) / seconds : 0.0;
  };
  return {.camera = rate(render.rays.camera),
          .mirror = rate(render.rays.mirror),
          .shadow = rate(render.rays.shadow)};
}

std::size_t peakMemoryBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::size_t{1024} * static_cast<std::size_t>(usage.ru_maxrss);
}

}  // namespace lavaray
