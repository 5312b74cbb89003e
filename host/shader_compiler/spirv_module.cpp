#include "shader_compiler/spirv_module.hpp"

#include <algorithm>

#include <spirv-tools/libspirv.hpp>

namespace lavaray {
namespace {

// Characters are packed four to a word, the first in the lowest byte, and end with a zero.
std::string text(std::span<const std::uint32_t> words) {
  std::string result;
  for (const std::uint32_t word : words) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      const auto c = static_cast<char>((word >> shift) & 0xFFU);
      if (c == '\0') return result;
      result += c;
    }
  }
  return result;
}

void readMember(std::span<const std::uint32_t> operands, SpirvModule& module) {
  SpirvMember& member = module.members[operands[0]][operands[1]];
  const auto kind = static_cast<spv::Decoration>(operands[2]);
  if (kind == spv::DecorationOffset) member.offset = operands[3];
  if (kind == spv::DecorationMatrixStride) member.matrixStride = operands[3];
  if (kind == spv::DecorationRowMajor) member.isRowMajor = true;
}

void readInstruction(const SpirvInstruction& instruction, SpirvModule& module) {
  const auto& [code, operands, position] = instruction;
  if (code == spv::OpCapability) {
    module.capabilities.push_back(static_cast<spv::Capability>(operands[0]));
  } else if (code == spv::OpExecutionMode && operands[1] == spv::ExecutionModeLocalSize) {
    module.localSize.assign(operands.begin() + 2, operands.end());
  } else if (code == spv::OpName) {
    module.names[operands[0]] = text(operands.subspan(1));
  } else if (code == spv::OpDecorate) {
    module.decorations[operands[0]][static_cast<spv::Decoration>(operands[1])] =
        operands.size() > 2 ? operands[2] : 0;
  } else if (code == spv::OpMemberDecorate) {
    readMember(operands, module);
  } else if (code >= spv::OpTypeVoid && code <= spv::OpTypeFunction) {
    module.types[operands[0]] = {code, operands.subspan(1), position};
  } else if (code >= spv::OpConstantTrue && code <= spv::OpSpecConstantOp) {
    module.constants[operands[1]] = instruction;
  } else if (code == spv::OpVariable && operands[2] != spv::StorageClassFunction) {
    module.variables[operands[1]] = instruction;
  }
}

}  // namespace

std::string SpirvModule::name(std::uint32_t id) const {
  const auto found = names.find(id);
  return found == names.end() ? std::string() : found->second;
}

std::optional<std::uint32_t> SpirvModule::decoration(std::uint32_t id, spv::Decoration kind) const {
  const auto found = decorations.find(id);
  if (found == decorations.end() || !found->second.contains(kind)) return std::nullopt;
  return found->second.at(kind);
}

std::optional<std::uint64_t> SpirvModule::sizeInBlock(std::uint32_t type, const SpirvMember& member) const {
  const auto& [code, operands, position] = types.at(type);
  switch (code) {
    case spv::OpTypeInt:
    case spv::OpTypeFloat:
      return operands[0] / 8;
    case spv::OpTypeVector:
      return sizeInBlock(operands[0]).value() * operands[1];
    case spv::OpTypeMatrix: {
      const std::uint32_t rows = types.at(operands[0]).operands[1];
      return std::uint64_t{member.matrixStride} * (member.isRowMajor ? rows : operands[1]);
    }
    case spv::OpTypeRuntimeArray:
      return 0;
    case spv::OpTypeArray: {
      const SpirvInstruction& length = constants.at(operands[1]);
      if (length.code != spv::OpConstant) return std::nullopt;
      return std::uint64_t{decoration(type, spv::DecorationArrayStride).value()} * length.operands[2];
    }
    case spv::OpTypeStruct: {
      std::uint64_t size = 0;
      for (std::uint32_t i = 0; i < operands.size(); ++i) {
        const SpirvMember& inner = members.at(type).at(i);
        const std::optional<std::uint64_t> innerSize = sizeInBlock(operands[i], inner);
        if (!innerSize) return std::nullopt;
        size = std::max(size, inner.offset + *innerSize);
      }
      return size;
    }
    case spv::OpTypePointer:  // an address
      return 8;
    default:
      return std::nullopt;
  }
}

SpirvModule readSpirv(std::span<const std::uint32_t> words) {
  SpirvModule module;
  for (const SpirvInstruction& instruction : spirvInstructions(words)) readInstruction(instruction, module);
  return module;
}

std::string capabilityName(spv::Capability capability) {
  // The disassembler is all that has the names in every version of the libraries.
  constexpr std::uint32_t kVersion = 0x00010500;
  constexpr std::uint32_t kWords = 2;
  const std::vector<std::uint32_t> module{
      spv::MagicNumber, kVersion, 0, 1, 0, kWords << spv::WordCountShift | spv::OpCapability, capability};
  const std::string before = "OpCapability ";
  std::string text;
  const spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_2);
  if (!tools.Disassemble(module, &text, SPV_BINARY_TO_TEXT_OPTION_NO_HEADER) || !text.starts_with(before))
    return std::to_string(capability);
  return text.substr(before.size(), text.find('\n') - before.size());
}

}  // namespace lavaray
