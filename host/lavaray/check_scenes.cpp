#include "lavaray/check_scenes.hpp"

#include <iostream>

#include "base/output_file.hpp"
#include "lavaray/inputs.hpp"
#include "lavaray/json_report.hpp"
#include "lavaray/run_report.hpp"
#include "lavaray/scene_loop.hpp"
#include "lavaray/text_report.hpp"

namespace lavaray {
namespace {

ExitCode checkScene(const Options& options) {
  UserShader none({});
  Inputs inputs(options, none);
  inputs.readScene({});
  printWarnings(std::cerr, inputs.takeWarnings());
  const Scene& scene = inputs.scene();
  const ImageSize size = outputSize(options, imageSize(scene.camera).value());
  const SceneReport report = reportScene(scene);
  printScene(std::cerr, report);
  if (!options.json.empty()) {
    OutputFile file({"--json", options.json});
    writeJsonCheck(file.stream(), report, size);
    file.commit();
  }
  return ExitCode::kSuccess;
}

}  // namespace

ExitCode checkScenes(const std::vector<Options>& scenes) {
  return forEachScene(scenes, [&](std::size_t index) { return checkScene(scenes[index]); });
}

}  // namespace lavaray
