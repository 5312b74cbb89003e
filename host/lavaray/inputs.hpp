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

// What a render is made of: read from files, and kept from one render to the next. Only what depends on a
// changed file is made anew.
class Inputs {
 public:
  // Both must outlive it.
  Inputs(const Options& options, UserShader& shader);

  using Files = std::vector<std::filesystem::path>;

  // Read the scene and its meshes, or compile --shaders for it, unless that is done already and no changed
  // file calls for it anew. Return whether they did. If they throw, what they last made stays, except for a
  // shader of another kind of scene. Throw Error(kInput) reading `file:line: message`.
  bool readScene(const Files& changed);
  bool compileShaders(const Files& changed);
  // Makes the scene's arrays for the device; a new hierarchy only if something in it has changed.
  void flatten();
  [[nodiscard]] bool isFlattened() const { return gpuScene_.has_value(); }  // this scene or a former one

  // Whether there is a scene, and the shader that was asked for.
  [[nodiscard]] bool areComplete() const { return scene_ && shader_.isComplete(); }
  // Of the scene's text, for identities; of a file as it is now. Throws Error(kInput) if that cannot be read.
  [[nodiscard]] std::string sceneChecksum() const;
  // The warnings since the last call, each `file:line: message`.
  std::vector<std::string> takeWarnings() { return std::exchange(warnings_, {}); }
  [[nodiscard]] const Scene& scene() const { return *scene_; }
  [[nodiscard]] const GpuScene& gpuScene() const { return *gpuScene_; }
  // SPIR-V; empty for the shader that the program was built with.
  [[nodiscard]] std::span<const std::uint32_t> shader() const { return shader_.spirv(); }
  // All files that were last read, or that reading was last tried of.
  [[nodiscard]] Files files() const;

 private:
  Scene readSceneText();
  Mesh readMesh(const std::filesystem::path& file);
  void forgetFormerFiles();

  const Options& options_;
  UserShader& shader_;
  Files sceneFiles_;                            // the scene and its meshes
  std::set<std::filesystem::path> changed_;     // those of them that have not been read successfully since
  std::set<std::filesystem::path> notedFiles_;  // by noteRead for the scene
  std::optional<std::string> standardInput_;    // if the scene is that, as it can be read only once
  std::optional<Scene> scene_;
  std::optional<Scene> flattened_;  // the scene that gpuScene_ was made from, if it is not scene_ any more
  std::optional<GpuScene> gpuScene_;
  std::vector<std::string> warnings_;
};

}  // namespace lavaray
