#include "shader_compiler/exact_spirv.hpp"

#include <cstddef>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include <spirv-tools/optimizer.hpp>

#include "shader_compiler/spirv_instructions.hpp"

namespace lavaray {
namespace {

// The operations that round and that NoContraction may decorate: Khronos, "SPIR-V Specification",
// version 1.5, "Arithmetic Instructions".
bool isRounded(spv::Op code) {
  switch (code) {
    case spv::OpFAdd:
    case spv::OpFSub:
    case spv::OpFMul:
    case spv::OpFDiv:
    case spv::OpFRem:
    case spv::OpFMod:
    case spv::OpVectorTimesScalar:
    case spv::OpMatrixTimesScalar:
    case spv::OpVectorTimesMatrix:
    case spv::OpMatrixTimesVector:
    case spv::OpMatrixTimesMatrix:
    case spv::OpOuterProduct:
    case spv::OpDot:
      return true;
    default:
      return false;
  }
}

// A module's sections have a fixed order: decorations, then types, then functions.
bool beginsDecorations(spv::Op code) {
  return code == spv::OpDecorate || code == spv::OpMemberDecorate || code == spv::OpTypeVoid;
}

void appendDecoration(std::vector<std::uint32_t>& spirv, std::uint32_t id) {
  constexpr std::uint32_t kWords = 3;
  spirv.insert(spirv.end(),
               {(kWords << spv::WordCountShift) | spv::OpDecorate, id, spv::DecorationNoContraction});
}

std::vector<std::uint32_t> markExact(std::span<const std::uint32_t> spirv) {
  std::vector<std::uint32_t> rounded;
  std::set<std::uint32_t> marked;
  std::optional<std::size_t> decorations;
  for (const auto& [code, operands, position] : spirvInstructions(spirv)) {
    if (!decorations && beginsDecorations(code)) decorations = position;
    if (code == spv::OpDecorate && operands[1] == spv::DecorationNoContraction) marked.insert(operands[0]);
    if (isRounded(code)) rounded.push_back(operands[1]);  // the result follows its type
  }
  if (!decorations) throw std::invalid_argument("this SPIR-V declares nothing");
  std::vector<std::uint32_t> exact(spirv.begin(), spirv.begin() + static_cast<std::ptrdiff_t>(*decorations));
  for (const std::uint32_t id : rounded) {
    if (!marked.contains(id)) appendDecoration(exact, id);
  }
  exact.insert(exact.end(), spirv.begin() + static_cast<std::ptrdiff_t>(*decorations), spirv.end());
  return exact;
}

// What it takes to unroll loops. Nothing is marked yet: the copies of an operation would not have its mark,
// and passes that come after would fuse them.
const std::vector<std::string> kUnrolling{"--ssa-rewrite", "--loop-unroll"};

// SPIRV-Tools' passes for size (2023.1), but for the unrolling in their midst.
const std::vector<std::string> kPasses{"--wrap-opkill",
                                       "--eliminate-dead-branches",
                                       "--merge-return",
                                       "--inline-entry-points-exhaustive",
                                       "--eliminate-dead-functions",
                                       "--private-to-local",
                                       "--scalar-replacement=0",
                                       "--ssa-rewrite",
                                       "--ccp",
                                       "--eliminate-dead-branches",
                                       "--simplify-instructions",
                                       "--scalar-replacement=0",
                                       "--eliminate-local-single-store",
                                       "--if-conversion",
                                       "--simplify-instructions",
                                       "--eliminate-dead-code-aggressive",
                                       "--eliminate-dead-branches",
                                       "--merge-blocks",
                                       "--convert-local-access-chains",
                                       "--eliminate-local-single-block",
                                       "--eliminate-dead-code-aggressive",
                                       "--copy-propagate-arrays",
                                       "--vector-dce",
                                       "--eliminate-dead-inserts",
                                       "--eliminate-dead-members",
                                       "--eliminate-local-single-store",
                                       "--merge-blocks",
                                       "--ssa-rewrite",
                                       "--redundancy-elimination",
                                       "--simplify-instructions",
                                       "--eliminate-dead-code-aggressive",
                                       "--cfg-cleanup"};

std::vector<std::uint32_t> optimize(std::span<const std::uint32_t> spirv,
                                    const std::vector<std::string>& passes) {
  std::string reason = "no reason given";
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
  optimizer.SetMessageConsumer([&](spv_message_level_t /*level*/, const char* /*source*/,
                                   const spv_position_t& /*position*/, const char* text) { reason = text; });
  std::vector<std::uint32_t> optimized;
  if (!optimizer.RegisterPassesFromFlags(passes) || !optimizer.Run(spirv.data(), spirv.size(), &optimized)) {
    throw std::runtime_error("the SPIR-V optimizer fails: " + reason);
  }
  return optimized;
}

}  // namespace

std::vector<std::uint32_t> finishShader(std::span<const std::uint32_t> spirv) {
  return optimize(markExact(optimize(spirv, kUnrolling)), kPasses);
}

}  // namespace lavaray
