#include "options.hpp"

#include <iostream>

#include <CLI/CLI.hpp>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "scenes.hpp"

namespace lavaray::bench {

std::optional<Options> parseOptions(int argc, const char* const* argv) {
  Options options;
  options.meshFolder = LAVARAY_BENCH_MESHES;
  options.threads = hardwareThreads();
  bool quick = false;
  std::vector<int> size;
  CLI::App app(
      "Measures the time that lavaray and Embree take for the same rays, for pictures and for building.",
      "bench-speed");
  app.add_option("--meshes", options.scenes, "Scenes to measure, with commas between them. Default: all")
      ->type_name("A,B,..")
      ->delimiter(',')
      ->check(CLI::IsMember(sceneNames()));
  app.add_option("--mesh-folder", options.meshFolder,
                 "Where stanford-bunny.obj, nefertiti.obj and beast.obj are")
      ->type_name("FOLDER")
      ->capture_default_str();
  CLI::Option* rounds = app.add_option("--rounds", options.rounds, "How often each contestant runs, in turns")
                            ->type_name("N")
                            ->check(CLI::Range(1, 1000))
                            ->capture_default_str();
  app.add_option("--size", size, "Width and height of the pictures. Default: 512,512")
      ->type_name("W,H")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(1, 4096));
  app.add_option("--rays-per-lane", options.raysPerLane,
                 "How many rays an invocation of lavaray's traces together: one or more of 1, 2 and 4")
      ->type_name("A,B,..")
      ->delimiter(',')
      ->check(CLI::IsMember({1U, 2U, 4U}))
      ->capture_default_str();
  app.add_option("--parts", options.parts, "What to measure")
      ->type_name("A,B,..")
      ->delimiter(',')
      ->check(CLI::IsMember(options.parts))
      ->capture_default_str();
  app.add_flag("--quick", quick, "A first look: few scenes, 3 rounds");
  app.add_option("--threads", options.threads, "Threads of Embree and of building; the device has its own")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--device", options.device,
                 "Vulkan device, by number or part of its name. Default: the best one")
      ->type_name("N or NAME");
  app.add_option("--json", options.json, "File for all times, one by one")->type_name("FILE");
  app.footer("Run it on an idle machine, or look at the processor times, which a busy one disturbs less.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // help
    app.exit(success, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw Error(ExitCode::kUsage, std::string(error.what()) + "; bench-speed --help lists the options");
  }
  if (quick && rounds->count() == 0) options.rounds = 3;
  if (options.scenes.empty()) options.scenes = quick ? quickSceneNames() : sceneNames();
  if (!size.empty()) options.size = {size[0], size[1]};
  return options;
}

}  // namespace lavaray::bench
