#pragma once

#include <cstdint>
#include <string>

namespace lavaray {

// How much more memory the process can have, by the tightest of the machine's own, the process's limits
// (`ulimit -v` and `-d`) and those of its control groups (of version 1 or 2: containers, batch systems).
struct AvailableMemory {
  std::uint64_t bytes;
  std::string limit;  // like "this machine has left"
};
AvailableMemory availableMemory();

// Like 3.2 GB.
std::string inGigabytes(std::uint64_t bytes);

}  // namespace lavaray
