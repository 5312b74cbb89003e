#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <spirv/unified1/spirv.hpp>

namespace lavaray {

struct SpirvInstruction {
  spv::Op code;
  std::span<const std::uint32_t> operands;  // the result's type and number among them
};

// Where a struct's member lies.
struct SpirvMember {
  std::uint32_t offset = 0;
  std::uint32_t matrixStride = 0;
  bool isRowMajor = false;
};

// The declarations of a SPIR-V module; it refers to the words that it was read from.
// Based on: Khronos, "SPIR-V Specification", version 1.5.
struct SpirvModule {
  std::vector<spv::Capability> capabilities;
  std::vector<std::uint32_t> localSize;
  std::map<std::uint32_t, std::string> names;
  // By what is decorated and with what; the value is 0 for a decoration that has none.
  std::map<std::uint32_t, std::map<spv::Decoration, std::uint32_t>> decorations;
  std::map<std::uint32_t, std::map<std::uint32_t, SpirvMember>> members;  // by struct and index
  std::map<std::uint32_t, SpirvInstruction> types;                        // without the result's number
  // By result, and beginning with the type: constants, and variables outside functions.
  std::map<std::uint32_t, SpirvInstruction> constants;
  std::map<std::uint32_t, SpirvInstruction> variables;

  [[nodiscard]] std::string name(std::uint32_t id) const;  // empty where it has none
  [[nodiscard]] std::optional<std::uint32_t> decoration(std::uint32_t id, spv::Decoration kind) const;
  // Bytes up to the end of a value of this type in a block, whose last array may be of any length; empty
  // where it is not known before specialization.
  [[nodiscard]] std::optional<std::uint64_t> sizeInBlock(std::uint32_t type,
                                                         const SpirvMember& member = {}) const;
};

// Throws std::invalid_argument where these words are no module.
SpirvModule readSpirv(std::span<const std::uint32_t> words);

// As shaders' authors know it.
std::string capabilityName(spv::Capability capability);

}  // namespace lavaray
