#pragma once

#include <filesystem>

#include "shader_compiler/isolated_work.hpp"
#include "shader_compiler/shader_compiler.hpp"

namespace lavaray {

// Compiles each shader in a process of its own, so that a crash of the compiler becomes a ShaderError. (Valid
// shaders are known on which glslang 12.0 or 16.6 crash.) The main thread has to construct it before it
// starts other threads.
class IsolatedCompiler {
 public:
  IsolatedCompiler();
  // As compileRenderShader and compileOwnShader, but for one thread at a time.
  CompiledShader compile(const std::filesystem::path& directory, bool forFewPrimitives);
  CompiledShader compileOwn(const std::filesystem::path& file);
  // Whether the process that compiles is still there: it ends with the thread that made it.
  [[nodiscard]] bool isServing() const { return work_.isServing(); }

 private:
  CompiledShader compile(char request, const std::filesystem::path& path,
                         const std::filesystem::path& source);

  IsolatedWork work_;
};

}  // namespace lavaray
