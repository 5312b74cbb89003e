#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace lavaray {

// Sizes and results of the stress tests.

// Whether the environment variable LAVARAY_STRESS asks for the full sizes; see tools/test.
bool isFullSize();

// How many rays, images, ... a test takes.
inline std::size_t sized(std::size_t quick, std::size_t full) {
  return isFullSize() ? full : quick;
}

// "1,000,000"
std::string grouped(std::uint64_t number);

// Three significant digits.
std::string shortNumber(double number);

// Prints what the running test has found, success or not: "figure: Suite.Test: 0 leaks in 1,000,000 rays";
// before the name stands the device, where one is chosen for the tests. tools/test collects these lines.
void report(const std::string& figure);

}  // namespace lavaray
