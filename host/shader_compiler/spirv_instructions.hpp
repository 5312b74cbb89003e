#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <spirv/unified1/spirv.hpp>

namespace lavaray {

struct SpirvInstruction {
  spv::Op code;
  std::span<const std::uint32_t> operands;  // including the result's type and id
  std::size_t position;                     // of its first word in the module
};

// A SPIR-V module's instructions in order; they refer to the module's words.
// Throws std::invalid_argument where these words are no module.
// Based on: Khronos, "SPIR-V Specification", version 1.5.
std::vector<SpirvInstruction> spirvInstructions(std::span<const std::uint32_t> module);

}  // namespace lavaray
