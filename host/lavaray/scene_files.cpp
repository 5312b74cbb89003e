#include "lavaray/scene_files.hpp"

#include <lavaray/files.h>
#include <lavaray/scene.h>

#include <utility>

#include "lavaray/standard_input.hpp"

namespace lavaray {
namespace {

// Meshes as well: an earlier scene's picture might have replaced one when its own scene's turn comes.
void noteMeshes(const std::filesystem::path& scene) {
  try {
    for (const std::filesystem::path& file : Scene::filesOf(scene)) {
      if (file != scene) noteRead(file, "the mesh");
    }
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kInput) throw;
    // Reported when it is the scene's turn.
  }
}

}  // namespace

void checkFiles(const std::vector<Options>& scenes) {
  std::vector<OutputName> outputs;
  for (const Options& options : scenes) {
    if (!isStandardInput(options.scene)) {
      noteRead(options.scene, "the scene");
      if (scenes.size() > 1) noteMeshes(options.scene);
    }
    if (!options.resume.empty()) noteRead(options.resume, "the film");
    for (OutputName& output : outputNames(options)) outputs.push_back(std::move(output));
  }
  checkOutputs(outputs);
}

}  // namespace lavaray
