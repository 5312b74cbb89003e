#pragma once

#include <cstdint>
#include <string>

namespace lavaray {

// How much more memory the process can get: what the tightest limit leaves, among the machine's own, those of
// the process (`ulimit -v` and `-d`) and those of its control groups (version 1 or 2: containers, batch
// systems).
struct AvailableMemory {
  std::uint64_t bytes;
  std::string limit;  // such as "this machine has left"
};
AvailableMemory availableMemory();

// Such as "3.2 GB".
std::string inGigabytes(std::uint64_t bytes);

}  // namespace lavaray
