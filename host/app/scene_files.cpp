#include "app/scene_files.hpp"

#include <list>
#include <system_error>

#include "app/standard_input.hpp"
#include "core/file_claims.hpp"

namespace lavaray {
namespace {

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
  if (scenes.size() > 1) return checkClaims(scenes);
  checkOutputs(outputNames(scenes.front()));
}

}  // namespace lavaray
