#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shader_compiler/isolated_compiler.hpp"

namespace lavaray {

// The shader of --shaders, compiled for either kind of scene; without that option, the shaders that the
// program was built with.
class UserShader {
 public:
  // `folder` may be empty. If it is not, this forks a process, so there must be no threads yet.
  explicit UserShader(std::filesystem::path folder);

  using Files = std::vector<std::filesystem::path>;

  // Compiles it for scenes with few primitives, or with more, unless that is done already and no changed file
  // calls for it anew. Returns whether it did. Adds to the warnings. Throws Error(kInput) reading `file:line:
  // message`; what was compiled before for that kind of scene then stays.
  bool compile(const Files& changed, bool forFewPrimitives, std::vector<std::string>& warnings);

  // Whether there is one for the kind of scene last compiled for, or none was asked for.
  [[nodiscard]] bool isComplete() const { return !compiler_ || !spirv().empty(); }
  // For that kind of scene; empty for the shader that the program was built with.
  [[nodiscard]] std::span<const std::uint32_t> spirv() const { return compiled_[forFewPrimitives_].spirv; }
  // The files last read for it, or that reading was last tried of.
  [[nodiscard]] const Files& files() const { return compiled_[forFewPrimitives_].files; }

 private:
  struct Compiled {
    std::vector<std::uint32_t> spirv;
    Files files;
  };

  std::filesystem::path folder_;
  std::optional<IsolatedCompiler> compiler_;
  std::array<Compiled, 2> compiled_;  // by forFewPrimitives
  bool forFewPrimitives_ = false;
};

}  // namespace lavaray
