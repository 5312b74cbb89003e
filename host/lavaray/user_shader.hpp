#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shader_compiler/isolated_compiler.hpp"

namespace lavaray {

// The shader of --shaders, compiled for the two kinds of scenes; without it the shaders that the program was
// built with.
class UserShader {
 public:
  // `folder` may be empty. With one a process is forked, so no thread must be there yet.
  explicit UserShader(std::filesystem::path folder);

  using Files = std::vector<std::filesystem::path>;

  // Compiles it for a scene that has few primitives, or more, where that was not done yet or one of the
  // changed files asks for it, and returns whether it did. Adds to the warnings. Throws Error(kInput) reading
  // `file:line: message`; then what there was for this kind of scene stays.
  bool compile(const Files& changed, bool forFewPrimitives, std::vector<std::string>& warnings);

  // Whether there is one for the kind of scene that was last compiled for, or none is asked for.
  [[nodiscard]] bool isComplete() const { return !compiler_ || !spirv().empty(); }
  // For that kind of scene; empty where it is what the program was built with.
  [[nodiscard]] std::span<const std::uint32_t> spirv() const { return compiled_[forFewPrimitives_].spirv; }
  // That were read for it last, or tried to be.
  [[nodiscard]] const Files& files() const { return compiled_[forFewPrimitives_].files; }

 private:
  struct Compiled {
    std::vector<std::uint32_t> spirv;
    Files files;
  };

  std::filesystem::path folder_;
  std::optional<IsolatedCompiler> compiler_;
  std::array<Compiled, 2> compiled_;  // by whether it is for few primitives
  bool forFewPrimitives_ = false;
};

}  // namespace lavaray
