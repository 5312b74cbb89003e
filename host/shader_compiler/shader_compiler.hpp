#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.hpp"

namespace lavaray {

struct CompiledShader {
  std::vector<std::uint32_t> spirv;
  // The source and its includes, as `directory / name`; of render.comp also interface.h.
  std::vector<std::filesystem::path> files;
  std::vector<std::string> warnings;  // `file:line: message`
};

// A shader that cannot be used. The message has one line `file:line: message` for each fault (`file: message`
// for one of the file as a whole), and no line twice; file() and line() are those of the first.
class ShaderError : public Error {
 public:
  ShaderError(const std::string& message, std::vector<std::filesystem::path> files);
  // The files that were read or looked for in vain: a change to one of them may mend the shader.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  ShaderError(const std::string& message, std::pair<std::string, std::size_t> location,
              std::vector<std::filesystem::path>&& files)
      : Error(ExitCode::kInput, message, std::move(location.first), location.second),
        files_(std::move(files)) {}

  std::vector<std::filesystem::path> files_;
};

// Called for each file of a shader when it is looked for.
using OnShaderFile = std::function<void(const std::filesystem::path&)>;

// Compiles `directory`/render.comp to the SPIR-V that the build would make of it, for a scene of few
// primitives or for any scene (see scene_data.glsl), and checks that it fits the program. Throws ShaderError
// where it does not compile or fit. May be called from any thread.
//
// The compiler has defects that end the process; see IsolatedCompiler.
CompiledShader compileRenderShader(
    const std::filesystem::path& directory, bool forFewPrimitives,
    const OnShaderFile& onFile = [](const std::filesystem::path&) {});

// The same for another shader over a scene's arrays, for any scene. What it includes is looked for in its own
// folder first, then among the shaders' headers that the program was built with.
CompiledShader compileOwnShader(
    const std::filesystem::path& file, const OnShaderFile& onFile = [](const std::filesystem::path&) {});

// Makes the compiler's tables, as the first compilation does otherwise.
void prepareCompiler();

}  // namespace lavaray
