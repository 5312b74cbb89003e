#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bvh/flatten.hpp"
#include "lavaray/options.hpp"
#include "lavaray/user_shader.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// What a render is made of, as read from files and kept from one render to the next: only what depends on a
// file that has changed is made anew.
class Inputs {
 public:
  // Both must outlive it.
  Inputs(const Options& options, UserShader& shader);

  using Files = std::vector<std::filesystem::path>;

  // Read the scene and its meshes, or compile --shaders for it, where that was not done yet or one of the
  // changed files asks for it, and return whether they did. Where they throw, what they made last stays, but
  // no shader that is for another kind of scene. Throw Error(kInput) reading `file:line: message`.
  bool readScene(const Files& changed);
  bool compileShaders(const Files& changed);
  // Makes the device's arrays of the scene; the hierarchy only where something in it has changed.
  void flatten();

  // Whether there is a scene, and the shader that is asked for.
  [[nodiscard]] bool areComplete() const { return scene_ && shader_.isComplete(); }
  // Of the scene's text, for identities; of a file as it is now. Throws Error(kInput) where that cannot be
  // read.
  [[nodiscard]] std::string sceneChecksum() const;
  // What was noticed since the last call, each `file:line: message`.
  std::vector<std::string> takeWarnings() { return std::exchange(warnings_, {}); }
  [[nodiscard]] const Scene& scene() const { return *scene_; }
  [[nodiscard]] const GpuScene& gpuScene() const { return *gpuScene_; }
  // SPIR-V; empty where it is what the program was built with.
  [[nodiscard]] std::span<const std::uint32_t> shader() const { return shader_.spirv(); }
  // All files that were read last, or tried to be.
  [[nodiscard]] Files files() const;

 private:
  Scene readSceneText();
  Mesh readMesh(const std::filesystem::path& file);
  void forgetFormerFiles();

  const Options& options_;
  UserShader& shader_;
  Files sceneFiles_;                            // the scene's and its meshes'
  std::set<std::filesystem::path> changed_;     // of them, those that were not read with success since
  std::set<std::filesystem::path> notedFiles_;  // by noteRead, for the scene
  std::optional<std::string> standardInput_;    // where the scene is that: it can be read once only
  std::optional<Scene> scene_;
  std::optional<Scene>
      flattened_;  // the scene that gpuScene_ was made from, where there was a newer one since
  std::optional<GpuScene> gpuScene_;
  std::vector<std::string> warnings_;
};

}  // namespace lavaray
