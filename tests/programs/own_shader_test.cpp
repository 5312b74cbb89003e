#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "shader_compiler/isolated_compiler.hpp"
#include "shader_compiler/shader_compiler.hpp"
#include "support/input_files.hpp"

namespace lavaray {
namespace {

constexpr const char* kDistance = R"(#version 460
#extension GL_GOOGLE_include_directive : require
#include "pixel.glsl"

void main() {
  const Pixel pixel = thisPixel();
  if (!pixel.isThere) return;
  setPixel(pixel, vec3(nearestHit(rayThrough(pixel)).t));
}
)";

// A shader in the folder of the running test, beside nothing else.
class OwnShaderTest : public testing::Test {
 protected:
  OwnShaderTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  // Numbers are from 1.
  void replaceLine(std::size_t number, const std::string& text) {
    std::size_t begin = 0;
    for (std::size_t i = 1; i < number; ++i) begin = text_.find('\n', begin) + 1;
    text_.replace(begin, text_.find('\n', begin) - begin, text);
    write("own.comp", text_);
  }
  [[nodiscard]] std::optional<ShaderError> error() const {
    try {
      (void)compileOwnShader(file_);
      return std::nullopt;
    } catch (const ShaderError& error) {
      return error;
    }
  }
  [[nodiscard]] std::string at(std::size_t line) const {
    return file_.string() + ":" + std::to_string(line) + ": ";
  }

  std::string text_ = kDistance;
  std::filesystem::path folder_ = testFolder() / "own";
  std::filesystem::path file_ = folder_ / "own.comp";
};

TEST_F(OwnShaderTest, IncludesTheHeadersOfTheProgram) {
  write("own.comp", kDistance);
  const CompiledShader shader = compileOwnShader(file_);
  EXPECT_FALSE(shader.spirv.empty());
  EXPECT_TRUE(shader.warnings.empty());
  // A file that appears there would be included.
  EXPECT_EQ(shader.files, (std::vector<std::filesystem::path>{file_, folder_ / "pixel.glsl"}));
}

TEST_F(OwnShaderTest, TheProcessThatCompilesMakesTheSame) {
  IsolatedCompiler compiler;
  write("own.comp", kDistance);
  EXPECT_EQ(compiler.compileOwn(file_).spirv, compileOwnShader(file_).spirv);
  EXPECT_TRUE(compiler.isServing());
}

TEST_F(OwnShaderTest, ErrorsSayFileAndLine) {
  replaceLine(8, "  setPixel(pixel, nope);");
  const auto found = error();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->what(), at(8) + "'nope': undeclared identifier");
  EXPECT_EQ(found->file(), file_.string());
  EXPECT_EQ(found->line(), 8U);
}

TEST_F(OwnShaderTest, WhatTheProgramDoesNotHaveIsRefused) {
  replaceLine(4, "layout(std430, set = 0, binding = 13) buffer Own { float own[]; };");
  EXPECT_FALSE(error()) << "it is not used";
  replaceLine(8, "  own[0] = 1.0;");
  const auto found = error();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->what(), at(4) + "`Own` is binding 13, the program has bindings 0 to 12 only");
}

TEST_F(OwnShaderTest, MissingIncludesAreToldWhatThereIs) {
  replaceLine(3, "#include \"pixels.glsl\"");
  const auto found = error();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->line(), 3U);
  const std::string message = found->what();
  EXPECT_TRUE(message.starts_with(at(3))) << message;
  for (const char* there : {"beam.glsl", "interface.h", "work_state.glsl"}) {
    EXPECT_NE(message.find(there), std::string::npos) << message;
  }
}

TEST_F(OwnShaderTest, FilesBesideItComeFirst) {
  // A header of the program's still gets what it includes from there.
  write("camera.glsl", "#error of the user\n");
  write("own.comp", kDistance);
  EXPECT_FALSE(error());
  replaceLine(3, "#include \"camera.glsl\"\n#include \"pixel.glsl\"");
  const auto found = error();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->file(), (folder_ / "camera.glsl").string());
  EXPECT_EQ(found->line(), 1U);
}

TEST_F(OwnShaderTest, AnInterfaceOfItsOwnIsRefused) {
  write("interface.h", "const uint kWorkGroupSize = 32u;\n");
  replaceLine(3, "#include \"interface.h\"\n#include \"pixel.glsl\"");
  const auto found = error();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->file(), (folder_ / "interface.h").string());
  EXPECT_NE(std::string(found->what()).find("differs from the interface"), std::string::npos);
}

TEST_F(OwnShaderTest, MissingShaderIsAnError) {
  const auto found = error();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->file(), file_.string());
  EXPECT_EQ(found->files(), std::vector{file_});
}

}  // namespace
}  // namespace lavaray
