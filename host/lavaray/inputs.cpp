#include "lavaray/inputs.hpp"

#include "lavaray/standard_input.hpp"

namespace lavaray {

Scene readScene(const Options& options, Scene::Files* tried) {
  if (!isStandardInput(options.scene)) return Scene::read(options.scene, options.defaults, tried);
  // Its name has no folder, so that meshes are looked for in the current one.
  return Scene::parse(readStandardInput(), kStandardInputName, options.defaults);
}

Inputs::Inputs(const Options& options, std::optional<ShaderCompiler>& compiler)
    : options_(options), compiler_(compiler) {}

bool Inputs::readScene(const Files& changed) {
  if (!scene_) {
    scene_ = lavaray::readScene(options_, &tried_);
  } else if (!scene_->reread(changed)) {
    return false;
  }
  addWarnings(scene_->warnings());
  return true;
}

bool Inputs::compileShaders(const Files& changed) {
  if (!compiler_) return false;
  // Without a scene, mistakes in the shader are found all the same.
  const bool isNew = compiler_->compile(scene_ ? *scene_ : Scene(), changed);
  addWarnings(compiler_->takeWarnings());
  return isNew;
}

Inputs::Files Inputs::files() const {
  Files all = scene_ ? scene_->files() : tried_;
  if (compiler_) all.insert(all.end(), compiler_->files().begin(), compiler_->files().end());
  return all;
}

void Inputs::addWarnings(const std::vector<std::string>& warnings) {
  warnings_.insert(warnings_.end(), warnings.begin(), warnings.end());
}

}  // namespace lavaray
