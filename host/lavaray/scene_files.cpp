#include "lavaray/scene_files.hpp"

#include <utility>

#include "base/errors.hpp"
#include "base/file_claims.hpp"
#include "lavaray/standard_input.hpp"
#include "scene/scene_reader.hpp"

namespace lavaray {
namespace {

// Meshes as well: an earlier scene's picture might have replaced one when its own scene's turn comes.
void noteMeshes(const std::filesystem::path& scene) {
  try {
    (void)readScene(scene, [](const std::filesystem::path& mesh) {
      noteRead(mesh, "the mesh");
      return Mesh{};
    });
  } catch (const Error& error) {
    if (error.exitCode() != ExitCode::kInput) throw;
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
