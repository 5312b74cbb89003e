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
  // As compileRenderShader, but for one thread at a time.
  CompiledShader compile(const std::filesystem::path& directory, bool forFewPrimitives);

 private:
  IsolatedWork work_;
};

}  // namespace lavaray
