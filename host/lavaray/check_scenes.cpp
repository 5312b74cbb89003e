#include "lavaray/check_scenes.hpp"

#include <lavaray/files.h>

#include <iostream>

#include "lavaray/inputs.hpp"
#include "lavaray/json_report.hpp"
#include "lavaray/scene_loop.hpp"
#include "lavaray/text_report.hpp"

namespace lavaray {
namespace {

int checkScene(const Options& options) {
  const Scene scene = readScene(options);
  printWarnings(std::cerr, scene.warnings());
  const ImageSize size = pictureSize(scene, options.render);
  const SceneSummary summary = scene.summary();
  printScene(std::cerr, summary);
  if (!options.json.empty()) {
    OutputFile file({"--json", options.json});
    writeJsonCheck(file.stream(), summary, size);
    file.commit();
  }
  return 0;
}

}  // namespace

int checkScenes(const std::vector<Options>& scenes) {
  return forEachScene(scenes, [&](std::size_t index) { return checkScene(scenes[index]); });
}

}  // namespace lavaray
