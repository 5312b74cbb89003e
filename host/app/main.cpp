#include <iostream>

#include "app/options.hpp"
#include "app/program.hpp"
#include "app/report.hpp"
#include "app/session.hpp"
#include "core/scene_reader.hpp"

namespace lavaray {
namespace {

ExitCode run(const Options& options) {
  if (options.listDevices) {
    printDevices(std::cerr, vulkan::listDevices(vulkan::Instance(options.validate)));
    return ExitCode::kSuccess;
  }
  if (options.check) {
    const Scene scene = readScene(options.scene);
    for (const std::string& warning : scene.warnings) std::cerr << "warning: " << warning << '\n';
    printScene(std::cerr, scene);
    return ExitCode::kSuccess;
  }
  return Session(options).run();
}

}  // namespace
}  // namespace lavaray

int main(int argc, char** argv) {
  return lavaray::runProgram("lavaray", [&] {
    const auto options = lavaray::parseOptions(argc, argv);
    return options ? lavaray::run(*options) : lavaray::ExitCode::kSuccess;
  });
}
