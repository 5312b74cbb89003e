#include "shader_compiler/shader_compiler.hpp"

#include <malloc.h>
#include <sys/stat.h>
#include <algorithm>
#include <iostream>
#include <iterator>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "programs/shader_folder.hpp"
#include "renderFewPrimitivesSpirv.spv.h"
#include "renderSpirv.spv.h"

namespace lavaray {
namespace {

std::set<std::string> names(const std::vector<std::filesystem::path>& files,
                            const std::filesystem::path& folder) {
  std::set<std::string> result;
  for (const std::filesystem::path& file : files) {
    EXPECT_EQ(file.parent_path(), folder);
    EXPECT_TRUE(result.insert(file.filename()).second) << file << " is there twice";
  }
  return result;
}

// The source and its includes; there are no others but the one for shaders of users' own.
std::set<std::string> shaderFiles() {
  constexpr std::string_view kForUsers = "pixel.glsl";
  std::set<std::string> result;
  for (const auto& entry : std::filesystem::directory_iterator(LAVARAY_SHADERS_DIR)) {
    const std::string name = entry.path().filename();
    if (name != "CMakeLists.txt" && name != kForUsers) result.insert(name);
  }
  return result;
}

TEST(ShaderCompiler, MakesTheWordsThatTheBuildMakes) {
  const CompiledShader shader = compileRenderShader(LAVARAY_SHADERS_DIR, false);
  EXPECT_TRUE(std::ranges::equal(shader.spirv, renderSpirv));
  EXPECT_TRUE(
      std::ranges::equal(compileRenderShader(LAVARAY_SHADERS_DIR, true).spirv, renderFewPrimitivesSpirv));
  EXPECT_EQ(names(shader.files, LAVARAY_SHADERS_DIR), shaderFiles());
  EXPECT_TRUE(shader.warnings.empty()) << shader.warnings[0];
}

TEST(ShaderCompiler, AnEditChangesTheWords) {
  const ShaderFolder folder;
  (void)folder.replace("view.glsl", "min(c, 1.0)", "min(c, 0.5)");
  EXPECT_FALSE(std::ranges::equal(compileRenderShader(folder.path(), false).spirv, renderSpirv));
}

TEST(ShaderCompiler, ErrorInTheSource) {
  const ShaderFolder folder;
  const std::string place = folder.replace("render.comp", "uint entryGroup(uvec2 first, uvec2 last) {",
                                           "uint entryGroup(uvec2 first, uvec2 last) { nope;");
  EXPECT_EQ(folder.error(), place + "'nope': undeclared identifier");
}

TEST(ShaderCompiler, ErrorInAnIncludeNamesIt) {
  const ShaderFolder folder;
  const std::string place = folder.replace("vector.glsl", "#endif", "int f(int a) { return a\n}\n#endif");
  const std::string message = folder.error();
  const std::string nextLine =
      (folder.path() / "vector.glsl").string() + ":" +
      std::to_string(std::stoi(place.substr(place.rfind(':', place.size() - 3) + 1)) + 1);
  EXPECT_EQ(message, nextLine + ": syntax error, unexpected RIGHT_BRACE, expecting COMMA or SEMICOLON");
}

TEST(ShaderCompiler, ErrorAfterAnIncludeHasTheIncludersLine) {
  const ShaderFolder folder;
  const std::string place = folder.replace("camera.glsl", "layout(std430", "oops layout(std430");
  EXPECT_EQ(folder.error().rfind(place, 0), 0U) << folder.error();
}

TEST(ShaderCompiler, ErrorInAFolderOfIncludes) {
  const ShaderFolder folder;
  std::filesystem::create_directory(folder.path() / "parts");
  folder.write("parts/a.glsl", "#include \"b.glsl\"\n#include \"vector.glsl\"\n");
  folder.write("parts/b.glsl", "\n\nfloat f() { return g(); }\n");
  (void)folder.replace("render.comp", "#include \"camera.glsl\"",
                       "#include \"parts/a.glsl\"\n#include \"camera.glsl\"");
  EXPECT_EQ(folder.error(),
            (folder.path() / "parts/b.glsl").string() + ":3: 'g': no matching overloaded function found");
  folder.write("parts/b.glsl", "\n");
  EXPECT_EQ(folder.error(), "");
}

TEST(ShaderCompiler, ErrorsOfTheLinkerHaveAPlace) {
  const ShaderFolder folder;
  std::string place = folder.replace("shade.glsl", "#endif", "int f(int a);\n#endif");
  (void)folder.replace("render.comp", "void main() {", "void main() {\n  if (f(1) == 0) return;");
  EXPECT_EQ(folder.error(), place + "No function definition (body) found: f");
  (void)folder.replace("render.comp", "void main() {",
                       "int g(int a) { return f(a); }\nint f(int a) { return g(a); }\nvoid main() {");
  const std::string message = folder.error();
  EXPECT_NE(message.find(": Recursion detected: "), std::string::npos) << message;
  folder.write("render.comp", "#version 460\nlayout(local_size_x = 64) in;\n");
  EXPECT_EQ(folder.error(), (folder.path() / "render.comp").string() +
                                ":1: Missing entry point: Each stage requires one entry point");
}

TEST(ShaderCompiler, MissingIncludeIsNamedAndWatched) {
  const ShaderFolder folder;
  const std::string place = folder.replace("path.glsl", "#include \"view.glsl\"", "#include \"vieuw.glsl\"");
  try {
    compileRenderShader(folder.path(), false);
    FAIL();
  } catch (const ShaderError& error) {
    EXPECT_EQ(error.what(), place + "#include \"vieuw.glsl\": no such file in " + folder.path().string());
    EXPECT_TRUE(names(error.files(), folder.path()).contains("vieuw.glsl"));
    EXPECT_TRUE(names(error.files(), folder.path()).contains("shade.glsl"));
  }
}

TEST(ShaderCompiler, MissingSourceOrFolder) {
  const ShaderFolder folder;
  std::filesystem::remove(folder.path() / "render.comp");
  EXPECT_EQ(folder.error(),
            (folder.path() / "render.comp").string() + ": cannot be read: No such file or directory");
  EXPECT_NE(inputError([&] {
              compileRenderShader(folder.path() / "nowhere", false);
            }).find("nowhere/render.comp: cannot be read"),
            std::string::npos);
  EXPECT_NE(inputError([&] {
              compileRenderShader(folder.path() / "camera.glsl", false);
            }).find("render.comp: cannot be read"),
            std::string::npos);
}

TEST(ShaderCompiler, WhatIsNoRegularFileIsNotOpened) {
  const ShaderFolder folder;
  std::filesystem::remove(folder.path() / "view.glsl");
  ASSERT_EQ(mkfifo((folder.path() / "view.glsl").c_str(), 0600), 0);
  EXPECT_NE(folder.error().find("#include \"view.glsl\": " + (folder.path() / "view.glsl").string() +
                                " cannot be read: it is no regular file"),
            std::string::npos);
  std::filesystem::remove(folder.path() / "view.glsl");
  std::filesystem::create_directory(folder.path() / "view.glsl");
  EXPECT_NE(folder.error().find("it is no regular file"), std::string::npos);
}

TEST(ShaderCompiler, EmptyFiles) {
  const ShaderFolder folder;
  folder.write("view.glsl", "");
  EXPECT_NE(folder.error().find(": 'kViewsSurface': undeclared identifier"), std::string::npos)
      << folder.error();
  folder.write("render.comp", " \n");
  EXPECT_EQ(folder.error(), (folder.path() / "render.comp").string() + ":1: the file is empty");
}

TEST(ShaderCompiler, FilesThatAreNoText) {
  const ShaderFolder folder;
  folder.write("view.glsl", std::string_view("// \n\0", 5));
  EXPECT_EQ(folder.error(), (folder.path() / "view.glsl").string() +
                                ":2: a NUL byte, allowed is plain text in ASCII or UTF-8");
  folder.write("view.glsl", "\n\xEF\xBB\xBF\n");
  EXPECT_EQ(folder.error(), (folder.path() / "view.glsl").string() +
                                ":2: a character that is not ASCII, allowed are such in comments only");
}

TEST(ShaderCompiler, IncludesWithoutEnd) {
  const ShaderFolder folder;
  folder.write("view.glsl", "\n#include \"view.glsl\"\n");
  const std::string view = (folder.path() / "view.glsl").string();
  EXPECT_EQ(folder.error(), view + ":2: #include \"view.glsl\": files include each other without end");
  // Their number doubles with every level.
  folder.write("view.glsl", "#include \"twice.glsl\"\n#include \"twice.glsl\"\n");
  folder.write("twice.glsl", "#include \"view.glsl\"\n#include \"view.glsl\"\n");
  EXPECT_NE(folder.error().find("files include each other without end"), std::string::npos);
}

TEST(ShaderCompiler, AGuardedFileMayIncludeItself) {
  const ShaderFolder folder;
  (void)folder.replace("vector.glsl", "#define VECTOR_GLSL", "#define VECTOR_GLSL\n#include \"vector.glsl\"");
  EXPECT_EQ(folder.error(), "");
}

TEST(ShaderCompiler, OtherIncludesAreRefused) {
  const ShaderFolder folder;
  const std::string place =
      folder.replace("render.comp", "#include \"camera.glsl\"", "#include <camera.glsl>");
  EXPECT_EQ(folder.error(), place + "#include \"camera.glsl\": allowed are includes in double quotes");
}

TEST(ShaderCompiler, ErrorAndWarningOfTheSourcesOwn) {
  const ShaderFolder folder;
  const std::string place = folder.replace("shade.glsl", "#endif", "#extension GL_FOO : enable\n#endif");
  const CompiledShader shader = compileRenderShader(folder.path(), false);
  ASSERT_EQ(shader.warnings.size(), 1U);
  EXPECT_EQ(shader.warnings[0], place + "'#extension': extension not supported: GL_FOO");
  const std::string place2 = folder.replace("shade.glsl", "#endif", "#error not here\n#endif");
  EXPECT_EQ(folder.error(), place2 + "#error not here");
  // No control character reaches a terminal.
  const std::string place3 = folder.replace("shade.glsl", "#error not here", "\x1b");
  EXPECT_EQ(folder.error(), place3 + "'?': unexpected token");
}

// Deletes, inserts or replaces some characters, or puts in a piece of the text again.
std::string edited(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  const std::size_t at = below(text.size());
  const std::size_t length = std::min(1 + below(below(4) == 0 ? 60 : 3), text.size() - at);
  switch (below(4)) {
    case 0:
      return text.erase(at, length);
    case 1:
      return text.insert(at, text.substr(below(text.size()), 4 * length));
    case 2:
      for (std::size_t i = 0; i < length; ++i) text.insert(at, 1, static_cast<char>(below(256)));
      return text;
    default:
      for (std::size_t i = 0; i < length; ++i) text[at + i] = static_cast<char>(32 + below(95));
      return text;
  }
}

TEST(ShaderCompiler, RandomEditsGiveAShaderOrAPlace) {
  const ShaderFolder folder;
  const std::set<std::string> files = shaderFiles();
  std::mt19937 random(2718);
  int errors = 0;
  for (int i = 0; i < 100; ++i) {
    const std::string name = *std::next(files.begin(), static_cast<int>(random() % files.size()));
    const std::string before = folder.read(name);
    folder.write(name, edited(before, random));
    const std::string message = folder.error();
    // Each line begins with a place in one of the files.
    std::istringstream lines(message);
    for (std::string line; std::getline(lines, line);) {
      const std::string start = folder.path().string() + "/";
      ASSERT_EQ(line.rfind(start, 0), 0U) << line;
      const std::size_t colon = line.find(':', start.size());
      EXPECT_TRUE(files.contains(line.substr(start.size(), colon - start.size()))) << line;
      EXPECT_GT(std::stoi(line.substr(colon + 1)), 0) << line;
    }
    errors += message.empty() ? 0 : 1;
    folder.write(name, before);
  }
  EXPECT_GT(errors, 50);
  EXPECT_LT(errors, 100);
}

#ifndef __SANITIZE_ADDRESS__  // whose allocator has no such figures, but finds leaks
TEST(ShaderCompiler, TwoHundredCompilationsKeepNoMemory) {
  const ShaderFolder folder;
  folder.write("render.comp",
               "#version 460\n#extension GL_GOOGLE_include_directive : require\n"
               "#include \"scene_data.glsl\"\nlayout(local_size_x = 64) in;\n"
               "layout(std430, binding = 8) buffer Work { uvec4 work[]; };\n"
               "void main() { work[gl_GlobalInvocationID.x] = fetchNodeTexel(0, 0); }\n");
  const ShaderFolder wrong("wrong");
  (void)wrong.replace("shade.glsl", "#endif", "oops\n#endif");
  const auto used = [] {
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
  };
  const auto compileBoth = [&] {
    EXPECT_EQ(folder.error(), "");
    EXPECT_NE(wrong.error(), "");
  };
  compileBoth();
  const std::size_t before = used();
  for (int i = 0; i < 200; ++i) compileBoth();
  const std::size_t after = used();
  std::cout << "figure: memory that 200 compilations keep: " << static_cast<long>(after - before)
            << " bytes\n";
  EXPECT_LT(after, before + 10000);
}
#endif

}  // namespace
}  // namespace lavaray
