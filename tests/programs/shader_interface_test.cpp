#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <spirv-tools/libspirv.hpp>

#include "interface.h"
#include "programs/shader_folder.hpp"
#include "shader_compiler/shader_interface.hpp"
#include "shader_compiler/spirv_instructions.hpp"

namespace lavaray {
namespace {

TEST(ShaderInterface, AnEditedInterfaceNeedsABuild) {
  const std::string message =
      "differs from the interface that the program was built with: build the program anew to change it";
  const ShaderFolder folder;
  const std::string place =
      folder.replace("interface.h", "const uint kWorkGroupSize = 64u;", "const uint kWorkGroupSize = 32u;");
  EXPECT_EQ(folder.error(), place + message);
  // Also where it differs in a comment only, and where the shader has errors that may come from it.
  const ShaderFolder shorter("shorter");
  const std::string text = shorter.read("interface.h");
  shorter.write("interface.h", text.substr(0, text.size() - 1));
  const auto lines = std::count(text.begin(), text.end(), '\n');
  EXPECT_EQ(shorter.error(),
            (shorter.path() / "interface.h").string() + ":" + std::to_string(lines) + ": " + message);
  shorter.write("interface.h", text + "\n");
  EXPECT_EQ(shorter.error(),
            (shorter.path() / "interface.h").string() + ":" + std::to_string(lines + 1) + ": " + message);
  const std::string binding =
      shorter.replace("interface.h", "const uint kBindingNodes", "const uint kBindingKnots");
  EXPECT_EQ(shorter.error(), binding + message);
  std::filesystem::remove(shorter.path() / "interface.h");
  EXPECT_EQ(shorter.error(),
            (shorter.path() / "interface.h").string() + ": cannot be read: No such file or directory");
}

// An edit of one line of the shader, and what is said at that line.
struct Edit {
  const char* name;
  const char* file;
  const char* from;
  const char* to;
  const char* message;
};
void PrintTo(const Edit& edit, std::ostream* out) {
  *out << edit.name;
}

class MisfitAtLine : public testing::TestWithParam<Edit> {};

TEST_P(MisfitAtLine, IsReported) {
  const Edit& edit = GetParam();
  const ShaderFolder folder;
  const std::string place = folder.replace(edit.file, edit.from, edit.to);
  EXPECT_EQ(folder.error(), place + edit.message);
}

static_assert(gpu::kBindingCount == 13 && gpu::kTexelBindings == 8 && gpu::kBindingWork == 9 &&
              gpu::kBindingStatus == 12);
static_assert(gpu::kSpecCount == 16 && gpu::kSpecPlaneCount == 3 && gpu::kWorkGroupSize == 64);
static_assert(sizeof(gpu::DispatchConstants) == 64);

constexpr const char* kPushConstants = "PushConstants {\n  DispatchConstants constants;\n}";

constexpr Edit kEdits[] = {
    {"BindingPastTheLast", "render.comp", "binding = kBindingWork", "binding = 13",
     "`Work` is binding 13, the program has bindings 0 to 12 only"},
    {"StorageBufferWhereTexelsAre", "render.comp", "binding = kBindingWork",
     "binding = kBindingTrianglePlanes", "`Work` is binding 2, which is one utextureBuffer in the program"},
    {"TexelsWhereAStorageBufferIs", "scene_data.glsl", "binding = kBindingNodes", "binding = kBindingFilter",
     "`nodeTexels` is binding 8, which is one storage buffer in the program"},
    {"UniformBuffer", "render.comp",
     "layout(std430, set = 0, binding = kBindingWork) readonly buffer Work {\n  WorkItem work[];\n}",
     "layout(set = 0, binding = kBindingWork) uniform Work { WorkItem work[4]; }",
     "`Work` is binding 9, which is one storage buffer in the program"},
    {"ArrayOfBuffers", "render.comp", "buffer States {\n  WorkState unfinishedItems[];\n};",
     "buffer States { WorkState unfinishedItems[]; } s[2];\n#define unfinishedItems s[1].unfinishedItems",
     "`States` is binding 11, which is one storage buffer in the program"},
    {"OtherSet", "render.comp", "set = 0, binding = kBindingWork", "set = 1, binding = kBindingWork",
     "`Work` is binding 9 of descriptor set 1, the program has set 0 only"},
    {"LongerPushConstants", "render.comp", kPushConstants,
     "PushConstants { DispatchConstants constants; vec3 more; }",
     "`PushConstants` has 76 bytes of push constants, the program's have 64"},
    {"LaterPushConstants", "render.comp", kPushConstants,
     "PushConstants { layout(offset = 16) DispatchConstants constants; }",
     "`PushConstants` has 80 bytes of push constants, the program's have 64"},
    {"PushConstantMatrix", "render.comp", kPushConstants,
     "PushConstants { DispatchConstants constants; mat2x3 m[2]; }",
     "`PushConstants` has 128 bytes of push constants, the program's have 64"},
    {"OtherWorkGroup", "render.comp", "local_size_x = kWorkGroupSize", "local_size_x = 32, local_size_y = 2",
     "a work group is 32 x 2 x 1, the program's is 64 x 1 x 1"},
    {"SpecializedWorkGroup", "render.comp", "local_size_x = kWorkGroupSize", "local_size_x_id = 3",
     "the size of a work group must not be a specialization constant"},
    {"UnknownSpecialization", "lane_use.glsl", "constant_id = kSpecCountRays", "constant_id = 16",
     "`kCountRays` is specialization constant 16, the program has 0 to 15 only"},
    {"FloatSpecialization", "scene_data.glsl", "const uint kPlaneCount = 0u;",
     "const float kPlanes = 0.0; uint kPlaneCount = uint(kPlanes);",
     "`kPlanes` is specialization constant 3, which is a bool or an integer of 32 bits in the program"},
};
INSTANTIATE_TEST_SUITE_P(ShaderInterface, MisfitAtLine, testing::ValuesIn(kEdits),
                         [](const auto& edit) { return edit.param.name; });

TEST(ShaderInterface, FloatTexelsAreRefused) {
  const ShaderFolder folder;
  (void)folder.replace(
      "scene_data.glsl", "return TEXEL(nodeTexels, index * kTexelsPerNode + texel);",
      "return floatBitsToUint(texelFetch(nodeTexels, int(index * kTexelsPerNode + texel)));");
  const std::string place = folder.replace("scene_data.glsl", "uniform utextureBuffer nodeTexels",
                                           "uniform textureBuffer nodeTexels");
  EXPECT_EQ(folder.error(), place + "`nodeTexels` is binding 0, which is one utextureBuffer in the program");
}

TEST(ShaderInterface, FeaturesThatAreNotEnabled) {
  const ShaderFolder folder;
  (void)folder.replace("render.comp", "void main() {",
                       "void main() {\n  if (double(constants.seed) * 0.1lf > 1e30lf) return;");
  EXPECT_EQ(folder.error(),
            (folder.path() / "render.comp").string() +
                ":1: the shader needs the SPIR-V capability Float64, which the program does not enable");
}

TEST(ShaderInterface, EveryMisfitIsReportedOnce) {
  const ShaderFolder folder;
  const std::string first = folder.replace("render.comp", "binding = kBindingWork)", "binding = 13)");
  const std::string second = folder.replace("render.comp", "binding = kBindingResults)", "binding = 14)");
  const std::string message = folder.error();
  EXPECT_EQ(message, first + "`Work` is binding 13, the program has bindings 0 to 12 only\n" + second +
                         "`Results` is binding 14, the program has bindings 0 to 12 only");
}

TEST(ShaderInterface, WhatIsNotUsedMayDiffer) {
  const ShaderFolder folder;
  (void)folder.replace(
      "render.comp", "layout(local_size_x",
      "layout(std430, set = 3, binding = 99) buffer Unused { uint unused[]; };\nlayout(local_size_x");
  EXPECT_EQ(folder.error(), "");
}

// A module whose push constants are so many vectors of 16 bytes.
std::vector<std::uint32_t> moduleWithPushConstants(int count) {
  std::string members;
  std::string offsets;
  for (int i = 0; i < count; ++i) {
    members += " %vector";
    offsets +=
        "OpMemberDecorate %Constants " + std::to_string(i) + " Offset " + std::to_string(16 * i) + "\n";
  }
  const std::string text =
      "OpCapability Shader\nOpMemoryModel Logical GLSL450\n"
      "OpEntryPoint GLCompute %main \"main\" %constants\nOpExecutionMode %main LocalSize 64 1 1\n"
      "OpName %Constants \"Constants\"\nOpDecorate %Constants Block\n" +
      offsets +
      "%void = OpTypeVoid\n%function = OpTypeFunction %void\n%float = OpTypeFloat 32\n"
      "%vector = OpTypeVector %float 4\n%Constants = OpTypeStruct" +
      members +
      "\n%pointer = OpTypePointer PushConstant %Constants\n%constants = OpVariable %pointer PushConstant\n"
      "%main = OpFunction %void None %function\n%begin = OpLabel\n%all = OpLoad %Constants %constants\n"
      "OpReturn\nOpFunctionEnd\n";
  const spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_2);
  std::vector<std::uint32_t> spirv;
  EXPECT_TRUE(tools.Assemble(text, &spirv));
  EXPECT_TRUE(tools.Validate(spirv));
  return spirv;
}

TEST(SpirvInstructions, AreReadOfWholeModulesOnly) {
  const std::vector<std::uint32_t> module = moduleWithPushConstants(1);
  const std::vector<SpirvInstruction> instructions = spirvInstructions(module);
  ASSERT_FALSE(instructions.empty());
  EXPECT_EQ(instructions.front().code, spv::OpCapability);
  EXPECT_EQ(instructions.back().code, spv::OpFunctionEnd);
  EXPECT_EQ(instructions.back().position, module.size() - 1);

  const std::span words(module);
  EXPECT_THROW(spirvInstructions({}), std::invalid_argument);
  EXPECT_THROW(spirvInstructions(words.subspan(1)), std::invalid_argument);
  std::vector<std::uint32_t> endless = module;
  endless.back() = spv::OpFunctionEnd;  // of no words
  EXPECT_THROW(spirvInstructions(endless), std::invalid_argument);
  std::vector<std::uint32_t> cutOff = module;
  cutOff.back() = 2U << spv::WordCountShift | spv::OpFunctionEnd;
  EXPECT_THROW(spirvInstructions(cutOff), std::invalid_argument);
}

// As spirv-opt of 2026 does with members that are not used.
TEST(ShaderInterface, MembersThatTheOptimizerTakesOutCount) {
  const std::vector<Misfit> misfits = findMisfits(moduleWithPushConstants(5), moduleWithPushConstants(4));
  ASSERT_EQ(misfits.size(), 1U);
  EXPECT_EQ(misfits[0].message, "`Constants` has 80 bytes of push constants, the program's have 64");
  EXPECT_TRUE(findMisfits(moduleWithPushConstants(4), moduleWithPushConstants(1)).empty());
}

TEST(ShaderInterface, FewerPushConstantsFit) {
  const ShaderFolder folder;
  folder.write("render.comp",
               "#version 460\nlayout(local_size_x = 64) in;\n"
               "layout(push_constant) uniform P { vec4 a; };\n"
               "layout(std430, binding = 8) buffer Work { vec4 work[]; };\nvoid main() { work[0] = a; }\n");
  EXPECT_EQ(folder.error(), "");
}

}  // namespace
}  // namespace lavaray
