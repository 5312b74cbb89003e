// Measures lavaray's speed against Embree's: the same rays, in one process, in turns.
#include <unistd.h>

#include <fstream>
#include <iostream>

#include "base/errors.hpp"
#include "command_line/program.hpp"
#include "experiment.hpp"
#include "library/guarded.hpp"
#include "options.hpp"
#include "peer.hpp"
#include "report.hpp"

namespace lavaray::bench {
namespace {

void showProgress(const std::string& text) {
  if (isatty(STDERR_FILENO) != 0) std::cerr << "\r\033[K" << text << std::flush;
}

ExitCode run(const Options& options) {
  const vulkan::Instance instance;
  vulkan::Device device(vulkan::chooseDevice(instance, options.device));
  Results results;
  results.device = device.description().name + ", " + device.description().driver;
  results.peer = embreeDescription();
  results.threads = options.threads;
  results.size = options.size;
  results.raysPerLane = options.raysPerLane;
  results.rounds = options.rounds;
  printHead(std::cout, results);
  for (const std::string& name : options.scenes) {
    const std::optional<BenchScene> scene = makeScene(name, options.meshFolder, options.size);
    if (!scene) {
      results.skipped.push_back(name + ": its mesh is not in " + options.meshFolder.string());
      std::cout << "\nskipped " << results.skipped.back() << '\n';
      continue;
    }
    results.scenes.push_back(measureScene(device, *scene, options, showProgress));
    showProgress("");
    printScene(std::cout, results.scenes.back());
  }
  printSummary(std::cout, results);
  if (!options.json.empty()) {
    std::ofstream file(options.json);
    writeJson(file, results);
    if (!file.flush()) throw Error(ExitCode::kOutput, options.json.string() + " cannot be written");
  }
  return ExitCode::kSuccess;
}

}  // namespace
}  // namespace lavaray::bench

int main(int argc, char** argv) {
  return lavaray::runProgram("bench-speed", [&] {
    return lavaray::guarded([&] {
      const auto options = lavaray::bench::parseOptions(argc, argv);
      return options ? static_cast<int>(lavaray::bench::run(*options)) : 0;
    });
  });
}
