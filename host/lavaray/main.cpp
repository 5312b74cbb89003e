#include <lavaray/device.h>

#include <iostream>

#include "command_line/program.hpp"
#include "lavaray/check_scenes.hpp"
#include "lavaray/options.hpp"
#include "lavaray/render_scenes.hpp"
#include "lavaray/scene_files.hpp"
#include "lavaray/text_report.hpp"
#include "lavaray/watch_scene.hpp"

namespace lavaray {
namespace {

void tellDevices(const Options& options) {
  // Before the drivers are loaded in this process, which one may end.
  if (options.verbose) {
    for (const std::string& line : describeDrivers()) std::cerr << line << '\n';
  }
  const DeviceList list = listDevices();
  printWarnings(std::cerr, list.warnings);
  printDevices(std::cerr, list.devices);
}

// The scenes' options differ only in the names of files.
int run(const std::vector<Options>& scenes) {
  const Options& options = scenes.front();
  if (options.listDevices) {
    tellDevices(options);
    return 0;
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
    const auto scenes = lavaray::parseOptions(argc, argv);
    return scenes.empty() ? 0 : lavaray::run(scenes);
  });
}
