#include "shader_compiler/shader_interface.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "base/text_location.hpp"
#include "interface.h"
#include "shader_compiler/built_in_sources.hpp"
#include "shader_compiler/spirv_module.hpp"

namespace lavaray {
namespace {

// The capabilities that every Vulkan 1.2 device has without being asked, and those of subgroup operations: a
// device that lacks some of these has no other name for them either.
constexpr std::array kCapabilities{
    spv::CapabilityShader,
    spv::CapabilityMatrix,
    spv::CapabilitySampledBuffer,
    spv::CapabilityImageQuery,
    spv::CapabilityGroupNonUniform,
    spv::CapabilityGroupNonUniformVote,
    spv::CapabilityGroupNonUniformArithmetic,
    spv::CapabilityGroupNonUniformBallot,
    spv::CapabilityGroupNonUniformShuffle,
    spv::CapabilityGroupNonUniformShuffleRelative,
    spv::CapabilityGroupNonUniformClustered,
    spv::CapabilityGroupNonUniformQuad,
};

class Comparison {
 public:
  Comparison(std::span<const std::uint32_t> written, std::span<const std::uint32_t> optimized)
      : module_(readSpirv(written)), optimized_(readSpirv(optimized)) {}

  std::vector<Misfit> run() {
    compareLocalSize();
    for (const auto& [id, variable] : module_.variables) {
      if (isLeft(id, variable)) compareVariable(id, variable);
    }
    for (const auto& [id, constant] : module_.constants) compareConstant(id, constant);
    for (const spv::Capability capability : optimized_.capabilities) {
      if (std::ranges::find(kCapabilities, capability) == kCapabilities.end())
        misfits_.push_back({{},
                            "the shader needs the SPIR-V capability " + capabilityName(capability) +
                                ", which the program does not enable"});
    }
    return std::move(misfits_);
  }

 private:
  // Where a variable is bound. That identifies it in two modules, whose ids differ.
  static auto bindingOf(const SpirvModule& module, std::uint32_t id, const SpirvInstruction& variable) {
    return std::tuple{variable.operands[2], module.decoration(id, spv::DecorationDescriptorSet),
                      module.decoration(id, spv::DecorationBinding)};
  }
  [[nodiscard]] bool isLeft(std::uint32_t id, const SpirvInstruction& variable) const {
    return std::ranges::any_of(optimized_.variables, [&](const auto& other) {
      return bindingOf(optimized_, other.first, other.second) == bindingOf(module_, id, variable);
    });
  }
  [[nodiscard]] bool isSpecializationLeft(std::uint32_t number) const {
    return std::ranges::any_of(optimized_.constants, [&](const auto& constant) {
      return optimized_.decoration(constant.first, spv::DecorationSpecId) == number;
    });
  }

  void compareLocalSize() {
    for (const auto& [id, constant] : module_.constants) {
      if (constant.code == spv::OpSpecConstantComposite &&
          module_.decoration(id, spv::DecorationBuiltIn) == spv::BuiltInWorkgroupSize) {
        misfits_.push_back(
            {"local_size_x_id", "the size of a work group must not be a specialization constant"});
        return;
      }
    }
    if (module_.localSize == std::vector<std::uint32_t>{gpu::kWorkGroupSize, 1, 1}) return;
    std::string size;
    for (const std::uint32_t side : module_.localSize)
      size += (size.empty() ? "" : " x ") + std::to_string(side);
    misfits_.push_back({"local_size_x", "a work group is " + size + ", the program's is " +
                                            std::to_string(gpu::kWorkGroupSize) + " x 1 x 1"});
  }

  void compareVariable(std::uint32_t id, const SpirvInstruction& variable) {
    const std::uint32_t type =
        module_.types.at(variable.operands[0]).operands[1];  // that the pointer points to
    const bool isStruct = module_.types.at(type).code == spv::OpTypeStruct;
    // A block is named by its type, also in an array of blocks.
    const std::uint32_t element =
        module_.types.at(type).code == spv::OpTypeArray ? module_.types.at(type).operands[0] : type;
    const std::string name = module_.name(module_.types.at(element).code == spv::OpTypeStruct ? element : id);
    switch (variable.operands[2]) {
      case spv::StorageClassInput:
      case spv::StorageClassPrivate:
      case spv::StorageClassWorkgroup:
        return;
      case spv::StorageClassPushConstant:
        comparePushConstants(name, type);
        return;
      default:
        compareBinding(id, name, variable.operands[2] == spv::StorageClassStorageBuffer && isStruct,
                       isTexelBuffer(type));
    }
  }

  void comparePushConstants(const std::string& name, std::uint32_t type) {
    const std::optional<std::uint64_t> size = module_.sizeInBlock(type);
    if (!size) {
      misfits_.push_back({name, "the size of push constants must not depend on specialization constants"});
    } else if (*size > sizeof(gpu::DispatchConstants)) {
      misfits_.push_back({name, backticked(name) + " has " + std::to_string(*size) +
                                    " bytes of push constants, the program's have " +
                                    std::to_string(sizeof(gpu::DispatchConstants))});
    }
  }

  // Whether it is a read-only buffer of unsigned integers, with or without a sampler, which it would not use.
  [[nodiscard]] bool isTexelBuffer(std::uint32_t type) const {
    const SpirvInstruction* image = &module_.types.at(type);
    if (image->code == spv::OpTypeSampledImage) image = &module_.types.at(image->operands[0]);
    if (image->code != spv::OpTypeImage) return false;
    constexpr std::uint32_t kNoStorage = 1;
    const SpirvInstruction& texel = module_.types.at(image->operands[0]);
    return image->operands[1] == spv::DimBuffer && image->operands[5] == kNoStorage &&
           texel.code == spv::OpTypeInt && texel.operands[0] == 32 && texel.operands[1] == 0;
  }

  void compareBinding(std::uint32_t id, const std::string& name, bool isStorage, bool isTexels) {
    const auto set = module_.decoration(id, spv::DecorationDescriptorSet).value_or(0);
    const auto binding = module_.decoration(id, spv::DecorationBinding).value_or(0);
    const std::string subject = backticked(name) + " is binding " + std::to_string(binding);
    if (set != 0) {
      misfits_.push_back(
          {name, subject + " of descriptor set " + std::to_string(set) + ", the program has set 0 only"});
    } else if (binding >= gpu::kBindingCount) {
      misfits_.push_back({name, subject + ", the program has bindings 0 to " +
                                    std::to_string(gpu::kBindingCount - 1) + " only"});
    } else if (binding < gpu::kTexelBindings ? !isTexels : !isStorage) {
      misfits_.push_back({name, subject + ", which is one " +
                                    (binding < gpu::kTexelBindings ? "utextureBuffer" : "storage buffer") +
                                    " in the program"});
    }
  }

  void compareConstant(std::uint32_t id, const SpirvInstruction& constant) {
    const std::optional<std::uint32_t> number = module_.decoration(id, spv::DecorationSpecId);
    if (!number || !isSpecializationLeft(*number)) return;
    const SpirvInstruction& type = module_.types.at(constant.operands[0]);
    const bool isWord =
        type.code == spv::OpTypeBool || (type.code == spv::OpTypeInt && type.operands[0] == 32);
    const std::string name = module_.name(id);
    if (*number >= gpu::kSpecCount) {
      misfits_.push_back({name, backticked(name) + " is specialization constant " + std::to_string(*number) +
                                    ", the program has 0 to " + std::to_string(gpu::kSpecCount - 1) +
                                    " only"});
    } else if (!isWord) {
      misfits_.push_back({name, backticked(name) + " is specialization constant " + std::to_string(*number) +
                                    ", which is a bool or an integer of 32 bits in the program"});
    }
  }

  SpirvModule module_;  // as written
  SpirvModule optimized_;
  std::vector<Misfit> misfits_;
};

}  // namespace

std::optional<std::size_t> firstDifference(std::string_view interface) {
  const std::string_view expected = builtInSource("interface.h").value();
  if (interface == expected) return std::nullopt;
  const auto [end, ignored] = std::ranges::mismatch(interface, expected);
  return 1 + static_cast<std::size_t>(std::count(interface.begin(), end, '\n'));
}

std::vector<Misfit> findMisfits(std::span<const std::uint32_t> written,
                                std::span<const std::uint32_t> optimized) {
  return Comparison(written, optimized).run();
}

}  // namespace lavaray
