#include <iostream>

#include "app/json_report.hpp"
#include "app/options.hpp"
#include "app/program.hpp"
#include "app/render_scenes.hpp"
#include "app/report.hpp"
#include "app/watch_scene.hpp"
#include "core/camera.hpp"
#include "core/file_claims.hpp"
#include "core/scene_reader.hpp"
#include "image/output_file.hpp"
#include "vulkan/driver_survey.hpp"

namespace lavaray {
namespace {

void listDevices(const Options& options) {
  // Before the drivers are loaded here: one may end the program.
  if (options.verbose) {
    for (const std::string& line : vulkan::surveyDrivers().lines(true)) std::cerr << line << '\n';
  }
  vulkan::Instance instance(options.validate);
  printWarnings(std::cerr, instance.takeWarnings());
  printDevices(std::cerr, vulkan::listDevices(instance));
}

ExitCode run(const Options& options) {
  if (options.listDevices) {
    listDevices(options);
    return ExitCode::kSuccess;
  }
  noteRead(options.scene, "the scene");
  if (!options.resume.empty()) noteRead(options.resume, "the film");
  checkOutputs(outputNames(options));
  if (options.check) {
    const Scene scene = readScene(options.scene);
    printWarnings(std::cerr, scene.warnings);
    const ImageSize size = outputSize(options, imageSize(scene.camera).value());
    printScene(std::cerr, scene);
    if (!options.json.empty()) {
      OutputFile file({"--json", options.json});
      writeJsonCheck(file.stream(), scene, size);
      file.commit();
    }
    return ExitCode::kSuccess;
  }
  return options.watch ? watchScene(options) : renderScene(options);
}

}  // namespace
}  // namespace lavaray

int main(int argc, char** argv) {
  return lavaray::runProgram("lavaray", [&] {
    const auto options = lavaray::parseOptions(argc, argv);
    return options ? lavaray::run(*options) : lavaray::ExitCode::kSuccess;
  });
}
