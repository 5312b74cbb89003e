#include "stress/spirv_module.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace lavaray {
namespace {

constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::size_t kHeaderWords = 5;

constexpr std::uint32_t kOpName = 5;
constexpr std::uint32_t kOpExtInst = 12;
constexpr std::uint32_t kOpFunction = 54;
constexpr std::uint32_t kOpDecorate = 71;
constexpr std::uint32_t kNoContraction = 42;
constexpr std::uint32_t kExtendedFma = 50;  // of GLSL.std.450, the only set that the shaders import

// OpFAdd, OpFSub, OpFMul, OpFDiv, then products of vectors and matrices up to OpDot. OpFNegate and
// comparisons round nothing.
constexpr std::array<std::uint32_t, 11> kRounding{129, 131, 133, 136, 142, 143, 144, 145, 146, 147, 148};

struct Instruction {
  std::uint32_t code;
  std::span<const std::uint32_t> operands;
};

template <typename Visit>
void visitInstructions(std::span<const std::uint32_t> spirv, const Visit& visit) {
  if (spirv.size() < kHeaderWords || spirv[0] != kMagic) throw std::invalid_argument("no SPIR-V module");
  for (std::size_t at = kHeaderWords; at < spirv.size();) {
    const std::size_t words = spirv[at] >> 16U;
    if (words == 0 || at + words > spirv.size())
      throw std::invalid_argument("a SPIR-V module that is cut off");
    visit(Instruction{spirv[at] & 0xFFFFU, spirv.subspan(at + 1, words - 1)});
    at += words;
  }
}

// Characters are packed four a word, the first one lowest, and end with a zero; glslang appends the
// parameters' types after a parenthesis.
std::string functionName(std::span<const std::uint32_t> words) {
  std::string name;
  for (const std::uint32_t word : words) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      const auto c = static_cast<char>((word >> shift) & 0xFFU);
      if (c == '\0' || c == '(') return name;
      name += c;
    }
  }
  return name;
}

}  // namespace

std::map<std::string, Arithmetic> arithmeticOf(std::span<const std::uint32_t> spirv) {
  std::map<std::uint32_t, std::string> names;
  std::set<std::uint32_t> decorated;
  std::map<std::string, Arithmetic> functions;
  Arithmetic* current = nullptr;
  visitInstructions(spirv, [&](const Instruction& instruction) {
    const auto& [code, operands] = instruction;
    if (code == kOpName) {
      names[operands[0]] = functionName(operands.subspan(1));
    } else if (code == kOpDecorate && operands[1] == kNoContraction) {
      decorated.insert(operands[0]);
    } else if (code == kOpFunction) {
      const std::uint32_t id = operands[1];
      current = &functions[names.contains(id) ? names[id] : std::to_string(id)];
    } else if (code == kOpExtInst && operands[3] == kExtendedFma) {
      ++current->fusedMultiplyAdds;
    } else if (std::find(kRounding.begin(), kRounding.end(), code) != kRounding.end()) {
      ++(decorated.contains(operands[1]) ? current->decorated : current->undecorated);
    }
  });
  return functions;
}

}  // namespace lavaray
