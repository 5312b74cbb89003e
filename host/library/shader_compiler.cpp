#include <lavaray/device.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/file_claims.hpp"
#include "bvh/scene_features.hpp"
#include "library/guarded.hpp"
#include "library/scene_state.hpp"
#include "shader_compiler/isolated_compiler.hpp"

namespace lavaray::v0 {
namespace {

bool haveCommon(const ShaderCompiler::Files& a, const ShaderCompiler::Files& b) {
  return std::ranges::find_first_of(a, b) != a.end();
}

// Another process reads them.
void note(const ShaderCompiler::Files& files) {
  for (const std::filesystem::path& file : files) lavaray::noteRead(file, "the shader");
}

}  // namespace

struct ShaderCompiler::State {
  struct Compiled {
    std::shared_ptr<const CompiledShader> shader;
    Files files;
  };

  explicit State(std::filesystem::path from) : folder(std::move(from)) {}

  Compiled& current() { return compiled[forFewPrimitives]; }

  std::filesystem::path folder;
  IsolatedCompiler compiler;
  std::array<Compiled, 2> compiled;  // by forFewPrimitives
  bool forFewPrimitives = false;
  std::vector<std::string> warnings;
};

ShaderCompiler::ShaderCompiler(const std::filesystem::path& folder)
    : state_(guarded([&] { return std::make_unique<State>(folder); })) {}
ShaderCompiler::~ShaderCompiler() = default;
ShaderCompiler::ShaderCompiler(ShaderCompiler&&) noexcept = default;
ShaderCompiler& ShaderCompiler::operator=(ShaderCompiler&&) noexcept = default;

bool ShaderCompiler::compile(const Scene& scene, const Files& changed) {
  return guarded([&] {
    State& state = *state_;
    state.forFewPrimitives = hasFewPrimitives(scene.state().scene);
    State::Compiled& other = state.compiled[!state.forFewPrimitives];
    if (haveCommon(changed, other.files)) other = {};
    State::Compiled& mine = state.current();
    if (mine.shader && !haveCommon(changed, mine.files)) return false;
    try {
      lavaray::CompiledShader made = state.compiler.compile(state.folder, state.forFewPrimitives);
      state.warnings.insert(state.warnings.end(), made.warnings.begin(), made.warnings.end());
      mine = {std::make_shared<CompiledShader>(CompiledShader{std::move(made.spirv)}), std::move(made.files)};
      note(mine.files);
    } catch (const ShaderError& error) {
      mine.files = error.files();
      note(mine.files);
      throw;
    }
    return true;
  });
}

std::shared_ptr<const CompiledShader> ShaderCompiler::shader() const {
  return state_->current().shader;
}

const ShaderCompiler::Files& ShaderCompiler::files() const {
  return state_->current().files;
}

std::vector<std::string> ShaderCompiler::takeWarnings() {
  return std::exchange(state_->warnings, {});
}

}  // namespace lavaray::v0
