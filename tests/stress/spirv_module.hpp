#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>

namespace lavaray {

// What a SPIR-V module says about its floating-point arithmetic. The numbers of instructions are from:
// Khronos, "SPIR-V Specification", version 1.5.

struct Arithmetic {
  int decorated = 0;    // sums, differences, products, quotients and dot products that are NoContraction
  int undecorated = 0;  // the others
  int fusedMultiplyAdds = 0;

  void operator+=(const Arithmetic& other) {
    decorated += other.decorated;
    undecorated += other.undecorated;
    fusedMultiplyAdds += other.fusedMultiplyAdds;
  }
};

// By function: its name without parameters, or its number where it has none.
std::map<std::string, Arithmetic> arithmeticOf(std::span<const std::uint32_t> spirv);

}  // namespace lavaray
