#pragma once

#include <cstdint>
#include <set>
#include <span>

namespace lavaray {

// What a SPIR-V module says about its floating-point arithmetic.
struct Arithmetic {
  int exact = 0;     // sums, differences, products and quotients that are NoContraction
  int others = 0;    // those that are not
  int products = 0;  // of vectors and matrices, whose order of adding is the driver's choice
  // By number: Khronos, "SPIR-V Extended Instructions for GLSL", version 1.00 (GLSL.std.450).
  std::set<std::uint32_t> builtIns;
};

// Throws std::invalid_argument where these words are no module.
Arithmetic arithmeticOf(std::span<const std::uint32_t> spirv);

}  // namespace lavaray
