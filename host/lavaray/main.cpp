#include <iostream>

#include "command_line/program.hpp"
#include "lavaray/check_scenes.hpp"
#include "lavaray/options.hpp"
#include "lavaray/render_scenes.hpp"
#include "lavaray/scene_files.hpp"
#include "lavaray/text_report.hpp"
#include "lavaray/watch_scene.hpp"
#include "library/guarded.hpp"
#include "vulkan/driver_survey.hpp"

namespace lavaray {
namespace {

void listDevices(const Options& options) {
  // Before the drivers are loaded in this process, which one may end.
  if (options.verbose) {
    for (const std::string& line : vulkan::surveyDrivers().lines(true)) std::cerr << line << '\n';
  }
  const vulkan::Instance instance;
  printWarnings(std::cerr, instance.warnings());
  printDevices(std::cerr, vulkan::listDevices(instance));
}

// The scenes' options differ only in the names of files.
ExitCode run(const std::vector<Options>& scenes) {
  const Options& options = scenes.front();
  if (options.listDevices) {
    listDevices(options);
    return ExitCode::kSuccess;
  }
  checkFiles(scenes);
  if (options.check) return checkScenes(scenes);
  if (options.watch) return watchScene(options);
  return renderScenes(scenes);
}

}  // namespace
}  // namespace lavaray

int main(int argc, char** argv) {
  return lavaray::runProgram("lavaray", [&] {
    return lavaray::guarded([&] {
      const auto scenes = lavaray::parseOptions(argc, argv);
      return scenes.empty() ? 0 : static_cast<int>(lavaray::run(scenes));
    });
  });
}
