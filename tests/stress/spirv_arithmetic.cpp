#include "stress/spirv_arithmetic.hpp"

#include <algorithm>
#include <array>

#include "shader_compiler/spirv_instructions.hpp"

namespace lavaray {
namespace {

// These round each component by itself. OpFNegate and comparisons round nothing.
constexpr std::array kRounding{spv::OpFAdd,
                               spv::OpFSub,
                               spv::OpFMul,
                               spv::OpFDiv,
                               spv::OpFRem,
                               spv::OpFMod,
                               spv::OpVectorTimesScalar,
                               spv::OpMatrixTimesScalar};

}  // namespace

Arithmetic arithmeticOf(std::span<const std::uint32_t> spirv) {
  Arithmetic arithmetic;
  std::set<std::uint32_t> exact;
  for (const auto& [code, operands, position] : spirvInstructions(spirv)) {
    if (code == spv::OpDecorate && operands[1] == spv::DecorationNoContraction) {
      exact.insert(operands[0]);
    } else if (code == spv::OpExtInst) {
      arithmetic.builtIns.insert(operands[3]);  // GLSL.std.450 is the only set that the shaders import
    } else if (code >= spv::OpVectorTimesMatrix && code <= spv::OpDot) {
      ++arithmetic.products;
    } else if (std::ranges::find(kRounding, code) != kRounding.end()) {
      ++(exact.contains(operands[1]) ? arithmetic.exact : arithmetic.others);
    }
  }
  return arithmetic;
}

}  // namespace lavaray
