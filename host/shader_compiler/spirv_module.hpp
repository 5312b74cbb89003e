#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shader_compiler/spirv_instructions.hpp"

namespace lavaray {

// The layout of a struct's member.
struct SpirvMember {
  std::uint32_t offset = 0;
  std::uint32_t matrixStride = 0;
  bool isRowMajor = false;
};

// The declarations of a SPIR-V module; they refer to the words that they were read from.
struct SpirvModule {
  std::vector<spv::Capability> capabilities;
  std::vector<std::uint32_t> localSize;
  std::map<std::uint32_t, std::string> names;
  // By the decorated id and the decoration; the value is 0 for a decoration without one.
  std::map<std::uint32_t, std::map<spv::Decoration, std::uint32_t>> decorations;
  std::map<std::uint32_t, std::map<std::uint32_t, SpirvMember>> members;  // by struct and index
  std::map<std::uint32_t, SpirvInstruction> types;                        // operands without the result's id
  // By the result's id, the operands beginning with the result's type: constants, and variables outside
  // functions.
  std::map<std::uint32_t, SpirvInstruction> constants;
  std::map<std::uint32_t, SpirvInstruction> variables;

  [[nodiscard]] std::string name(std::uint32_t id) const;  // empty where it has none
  [[nodiscard]] std::optional<std::uint32_t> decoration(std::uint32_t id, spv::Decoration kind) const;
  // Bytes up to the end of a value of this type in a block; a runtime array at the end counts as empty.
  // Nothing where the size is not known before specialization.
  [[nodiscard]] std::optional<std::uint64_t> sizeInBlock(std::uint32_t type,
                                                         const SpirvMember& member = {}) const;
};

// Throws std::invalid_argument where these words are no module.
SpirvModule readSpirv(std::span<const std::uint32_t> words);

// The name that shaders' authors know it by.
std::string capabilityName(spv::Capability capability);

}  // namespace lavaray
