#pragma once

#include <lavaray/device.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "library/file_stamps.hpp"
#include "shader_compiler/isolated_compiler.hpp"

namespace lavaray::v0 {

struct Shader::State {
  std::filesystem::path file;
  std::optional<IsolatedCompiler> compiler;
  std::vector<std::uint32_t> spirv;  // as last compiled without an error
  Files files;                       // these two: as last tried
  FileStamps stamps;
  std::vector<std::string> warnings;

  void compile();

 private:
  lavaray::CompiledShader compileIsolated();
};

}  // namespace lavaray::v0
