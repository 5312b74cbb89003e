#include "stress/spirv_arithmetic.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace lavaray {
namespace {

constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::size_t kHeaderWords = 5;

constexpr std::uint32_t kOpExtInst = 12;
constexpr std::uint32_t kOpDecorate = 71;
constexpr std::uint32_t kNoContraction = 42;

// OpFAdd, OpFSub, OpFMul, OpFDiv, OpFRem, OpFMod, OpVectorTimesScalar and OpMatrixTimesScalar round each
// component by itself. OpFNegate and comparisons round nothing.
constexpr std::array<std::uint32_t, 8> kRounding{129, 131, 133, 136, 140, 141, 142, 143};
// OpVectorTimesMatrix up to OpDot
constexpr std::uint32_t kFirstProduct = 144;
constexpr std::uint32_t kLastProduct = 148;

}  // namespace

Arithmetic arithmeticOf(std::span<const std::uint32_t> spirv) {
  if (spirv.size() < kHeaderWords || spirv[0] != kMagic) throw std::invalid_argument("no SPIR-V module");
  Arithmetic arithmetic;
  std::set<std::uint32_t> exact;
  for (std::size_t at = kHeaderWords; at < spirv.size();) {
    const std::size_t words = spirv[at] >> 16U;
    const std::uint32_t code = spirv[at] & 0xFFFFU;
    if (words == 0 || at + words > spirv.size())
      throw std::invalid_argument("a SPIR-V module that is cut off");
    const std::span<const std::uint32_t> operands = spirv.subspan(at + 1, words - 1);
    if (code == kOpDecorate && operands[1] == kNoContraction) {
      exact.insert(operands[0]);
    } else if (code == kOpExtInst) {
      arithmetic.builtIns.insert(operands[3]);  // GLSL.std.450 is the only set that the shaders import
    } else if (code >= kFirstProduct && code <= kLastProduct) {
      ++arithmetic.products;
    } else if (std::ranges::find(kRounding, code) != kRounding.end()) {
      ++(exact.contains(operands[1]) ? arithmetic.exact : arithmetic.others);
    }
    at += words;
  }
  return arithmetic;
}

}  // namespace lavaray
