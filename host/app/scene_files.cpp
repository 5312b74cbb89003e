#include "app/scene_files.hpp"

#include <list>
#include <system_error>

#include "app/standard_input.hpp"
#include "core/errors.hpp"
#include "core/file_claims.hpp"
#include "core/scene_reader.hpp"

namespace lavaray {
namespace {

// Meshes, too, since an earlier scene's picture may be in their place when their scene's turn comes.
void noteMeshes(const std::filesystem::path& scene) {
  try {
    (void)readScene(scene, [](const std::filesystem::path& mesh) {
      noteRead(mesh, "the mesh");
      return Mesh{};
    });
  } catch (const Error& error) {
    if (error.exitCode() != ExitCode::kInput) throw;
    // Told when it is the scene's turn.
  }
}

void checkClaims(const std::vector<Options>& scenes) {
  std::list<WriteClaim> claims;
  for (const Options& options : scenes) {
    for (const OutputName& output : outputNames(options)) {
      try {
        claims.emplace_back(WriteTarget(output.file), output.file, output.option, output.mayReplace);
      } catch (const std::system_error&) {
        // Links without an end; writing will fail.
      }
    }
  }
}

}  // namespace

void checkFiles(const std::vector<Options>& scenes) {
  for (const Options& options : scenes) {
    if (!isStandardInput(options.scene)) noteRead(options.scene, "the scene");
    if (!options.resume.empty()) noteRead(options.resume, "the film");
  }
  if (scenes.size() > 1) {
    for (const Options& options : scenes) {
      if (!isStandardInput(options.scene)) noteMeshes(options.scene);
    }
    return checkClaims(scenes);
  }
  checkOutputs(outputNames(scenes.front()));
}

}  // namespace lavaray
