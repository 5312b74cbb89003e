#include "shader_compiler/isolated_compiler.hpp"

#include <gtest/gtest.h>

#include "programs/shader_folder.hpp"

namespace lavaray {
namespace {

class IsolatedCompilerTest : public testing::Test {
 protected:
  IsolatedCompiler compiler_;
};

TEST_F(IsolatedCompilerTest, MakesWhatTheCompilerMakes) {
  const ShaderFolder folder;
  (void)folder.replace("shade.glsl", "#endif", "#extension GL_FOO : enable\n#endif");
  for (const bool forFewPrimitives : {false, true}) {
    const CompiledShader shader = compiler_.compile(folder.path(), forFewPrimitives);
    const CompiledShader expected = compileRenderShader(folder.path(), forFewPrimitives);
    EXPECT_EQ(shader.spirv, expected.spirv);
    EXPECT_EQ(shader.files, expected.files);
    EXPECT_EQ(shader.warnings, expected.warnings);
    EXPECT_EQ(shader.warnings.size(), 1U);
  }
}

TEST_F(IsolatedCompilerTest, SaysWhatTheCompilerSays) {
  const ShaderFolder folder;
  (void)folder.replace("path.glsl", "#include \"view.glsl\"", "#include \"vieuw.glsl\"");
  try {
    (void)compiler_.compile(folder.path(), false);
    FAIL();
  } catch (const ShaderError& error) {
    EXPECT_EQ(error.what(), folder.error());
    EXPECT_EQ(std::ranges::count(error.files(), folder.path() / "vieuw.glsl"), 1);
  }
}

}  // namespace
}  // namespace lavaray
