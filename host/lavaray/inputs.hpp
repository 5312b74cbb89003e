#pragma once

#include <lavaray/device.h>
#include <lavaray/scene.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lavaray/options.hpp"

namespace lavaray {

// Reads the scene and its meshes, from standard input where the options say so. If that fails, `tried` gets
// the files that it has read or tried to read.
Scene readScene(const Options& options, Scene::Files* tried = nullptr);

// What a render is made of: read from files, and kept from one render to the next. Only what depends on a
// changed file is made anew.
class Inputs {
 public:
  // Both must outlive it. The compiler is that of --shaders, if that is given.
  Inputs(const Options& options, std::optional<ShaderCompiler>& compiler);

  using Files = Scene::Files;

  // Read the scene and its meshes, or compile --shaders for it, unless that is done already and no changed
  // file calls for it anew. Return whether they did. If they throw, what they last made stays, except for a
  // shader of another kind of scene. Throw Error(kInput) reading `file:line: message`.
  bool readScene(const Files& changed);
  bool compileShaders(const Files& changed);

  // Whether there is a scene, and the shader that was asked for.
  [[nodiscard]] bool areComplete() const { return scene_ && (!compiler_ || shader()); }
  // The warnings since the last call, each `file:line: message`.
  std::vector<std::string> takeWarnings() { return std::exchange(warnings_, {}); }
  [[nodiscard]] const Scene& scene() const { return *scene_; }
  // Null for the shader that the program was built with.
  [[nodiscard]] std::shared_ptr<const CompiledShader> shader() const {
    return compiler_ ? compiler_->shader() : nullptr;
  }
  // All files that were last read, or that reading was last tried of.
  [[nodiscard]] Files files() const;

 private:
  void addWarnings(const std::vector<std::string>& warnings);

  const Options& options_;
  std::optional<ShaderCompiler>& compiler_;
  std::optional<Scene> scene_;
  Files tried_;  // as long as there is no scene
  std::vector<std::string> warnings_;
};

}  // namespace lavaray
