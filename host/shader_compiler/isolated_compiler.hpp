#pragma once

#include <filesystem>

#include "shader_compiler/isolated_work.hpp"
#include "shader_compiler/shader_compiler.hpp"

namespace lavaray {

// Compiles each shader in a process of its own, so that a compiler that ends the process is a ShaderError.
// (Valid shaders with which glslang 12.0 or 16.6 do so are known.) To be made by the main thread before there
// are others.
class IsolatedCompiler {
 public:
  IsolatedCompiler();
  // As compileRenderShader, but from one thread at a time.
  CompiledShader compile(const std::filesystem::path& directory, bool forFewPrimitives);

 private:
  IsolatedWork work_;
};

}  // namespace lavaray
