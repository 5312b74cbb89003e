#include "lavaray/inputs.hpp"

#include <algorithm>

#include "base/file_claims.hpp"
#include "base/parallel.hpp"
#include "film/film_file.hpp"
#include "lavaray/standard_input.hpp"
#include "scene/scene_reader.hpp"

namespace lavaray {
namespace fs = std::filesystem;

namespace {

bool haveCommon(const Inputs::Files& a, const Inputs::Files& b) {
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

}  // namespace

Inputs::Inputs(const Options& options, UserShader& shader) : options_(options), shader_(shader) {}

bool Inputs::readScene(const Files& changed) {
  if (scene_ && !haveCommon(changed, sceneFiles_)) return false;
  changed_.insert(changed.begin(), changed.end());
  sceneFiles_ = {options_.scene};
  Scene scene = readSceneText();
  applyDefaults(options_, scene);
  warnings_.insert(warnings_.end(), scene.warnings.begin(), scene.warnings.end());
  if (gpuScene_ && !flattened_) flattened_ = std::move(scene_);
  scene_ = std::move(scene);
  changed_.clear();
  forgetFormerFiles();
  return true;
}

// Files that only an earlier state of the scene named may be written again.
void Inputs::forgetFormerFiles() {
  for (const fs::path& file : notedFiles_) {
    if (std::find(sceneFiles_.begin(), sceneFiles_.end(), file) == sceneFiles_.end()) forgetRead(file);
  }
  notedFiles_ = {sceneFiles_.begin(), sceneFiles_.end()};
}

Scene Inputs::readSceneText() {
  const MeshReader reader = [this](const fs::path& file) { return readMesh(file); };
  if (!isStandardInput(options_.scene)) return lavaray::readScene(options_.scene, reader);
  if (!standardInput_) standardInput_ = readStandardInput();
  // Its name has no folder, so that meshes are looked for in the current one.
  return parseScene(*standardInput_, kStandardInputName, reader);
}

std::string Inputs::sceneChecksum() const {
  return standardInput_ ? checksumOf(std::as_bytes(std::span(*standardInput_)))
                        : checksumOfFile(options_.scene);
}

Mesh Inputs::readMesh(const fs::path& file) {
  sceneFiles_.push_back(file);
  noteRead(file, "the mesh");
  notedFiles_.insert(file);
  if (scene_ && !changed_.contains(file)) {
    const auto known = std::find_if(scene_->meshes.begin(), scene_->meshes.end(),
                                    [&](const Mesh& mesh) { return mesh.file == file; });
    if (known != scene_->meshes.end()) return *known;
  }
  return readObj(file);
}

bool Inputs::compileShaders(const Files& changed) {
  // Another process reads them.
  const auto noteFiles = [this] {
    for (const fs::path& file : shader_.files()) noteRead(file, "the shader");
  };
  try {
    const bool isNew = shader_.compile(changed, scene_ && hasFewPrimitives(*scene_), warnings_);
    noteFiles();
    return isNew;
  } catch (const ShaderError&) {
    noteFiles();
    throw;
  }
}

void Inputs::flatten() {
  if (!gpuScene_) {
    gpuScene_ = lavaray::flatten(*scene_, hardwareThreads());
  } else if (flattened_) {
    if (sameGeometry(*scene_, *flattened_)) {
      flattenShading(*scene_, *gpuScene_);
    } else {
      gpuScene_ = lavaray::flatten(*scene_, hardwareThreads());
    }
  }
  flattened_.reset();
}

Inputs::Files Inputs::files() const {
  Files all = sceneFiles_;
  all.insert(all.end(), shader_.files().begin(), shader_.files().end());
  return all;
}

}  // namespace lavaray
