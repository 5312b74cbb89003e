#include "library/shader_state.hpp"

#include <utility>

#include "base/file_claims.hpp"
#include "library/guarded.hpp"

namespace lavaray::v0 {

lavaray::CompiledShader Shader::State::compileIsolated() {
  if (compiler) {
    try {
      return compiler->compileOwn(file);
    } catch (const ShaderError&) {
      if (compiler->isServing()) throw;
    }
  }
  compiler.emplace();
  return compiler->compileOwn(file);
}

void Shader::State::compile() {
  const std::timespec before = FileStamps::now();
  const auto keepFiles = [&](Files read) {
    files = std::move(read);
    stamps = FileStamps(files, before);
    for (const std::filesystem::path& each : files) lavaray::noteRead(each, "the shader");
  };
  try {
    lavaray::CompiledShader made = compileIsolated();
    keepFiles(std::move(made.files));
    spirv = std::move(made.spirv);
    warnings.insert(warnings.end(), made.warnings.begin(), made.warnings.end());
  } catch (const ShaderError& error) {
    keepFiles(error.files());
    throw;
  }
}

Shader::Shader(const std::filesystem::path& file)
    : state_(guarded([&] {
        auto state = std::make_unique<State>();
        state->file = file;
        state->compile();
        return state;
      })) {}
Shader::~Shader() = default;
Shader::Shader(Shader&&) noexcept = default;
Shader& Shader::operator=(Shader&&) noexcept = default;

bool Shader::reload() {
  return guarded([&] {
    if (!state_->stamps.haveChanged()) return false;
    state_->compile();
    return true;
  });
}

const Shader::Files& Shader::files() const {
  return state_->files;
}

std::vector<std::string> Shader::takeWarnings() {
  return std::exchange(state_->warnings, {});
}

}  // namespace lavaray::v0
