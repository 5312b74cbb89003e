#include "shader_compiler/spirv_instructions.hpp"

#include <stdexcept>

namespace lavaray {

std::vector<SpirvInstruction> spirvInstructions(std::span<const std::uint32_t> module) {
  constexpr std::size_t kHeaderWords = 5;
  if (module.size() < kHeaderWords || module[0] != spv::MagicNumber)
    throw std::invalid_argument("no SPIR-V module");
  std::vector<SpirvInstruction> instructions;
  for (std::size_t at = kHeaderWords; at < module.size();) {
    const std::size_t count = module[at] >> spv::WordCountShift;
    if (count == 0 || count > module.size() - at)
      throw std::invalid_argument("a SPIR-V module that is cut off");
    const auto code = static_cast<spv::Op>(module[at] & spv::OpCodeMask);
    instructions.push_back({code, module.subspan(at + 1, count - 1), at});
    at += count;
  }
  return instructions;
}

}  // namespace lavaray
