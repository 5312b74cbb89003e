#include "lavaray/options.hpp"

#include <CLI/CLI.hpp>

#include "command_line/usage.hpp"
#include "command_line/version.hpp"
#include "lavaray/layers.hpp"
#include "lavaray/option_checks.hpp"
#include "lavaray/option_table.hpp"

namespace lavaray {

std::vector<Options> parseOptions(int argc, const char* const* argv) {
  Options options;
  std::vector<std::string> scenes;
  CLI::App app("Renders a scene file with Vulkan.", "lavaray");
  app.set_version_flag("--version", std::string("lavaray ") + kVersion);
  app.footer(
      "Exit codes: 0 fine, 1 internal error, 2 usage, 3 scene, mesh, shader or film, 4 no usable device,\n"
      "5 output not written or no screen for --display, 6 not enough memory, 129, 130 or 143 ended by\n"
      "SIGHUP, SIGINT or SIGTERM; what is rendered by then is written.");
  addOptions(app, options, scenes);
  if (!parseCommandLine(app, argc, argv)) return {};
  if (options.listDevices) return {options};
  if (scenes.empty()) throw Error(ErrorKind::kUsage, "SCENE is missing; lavaray --help lists the options");
  std::vector<Options> all = optionsOfScenes(options, scenes);
  for (const Options& one : all) checkOptions(one);
  return all;
}

std::vector<OutputName> outputNames(const Options& options) {
  std::vector<OutputName> names;
  if (!options.check && options.output != "-") names.push_back({"--output", options.output});
  for (const Layer layer : options.layers) {
    if (!options.check) names.push_back(layerOutput(options, layer));
  }
  if (!options.json.empty()) names.push_back({"--json", options.json});
  if (!options.check && !options.checkpoint.empty()) names.push_back(checkpointName(options));
  return names;
}

OutputName checkpointName(const Options& options) {
  return {"--checkpoint", options.checkpoint, options.resume};
}

bool writesFilm(const Options& options) {
  return std::filesystem::path(options.output).extension() == ".film";
}

std::optional<double> defaultTargetError(const Options& options, const SceneSummary& scene) {
  constexpr double kTargetError = 0.01;
  const RenderOptions& render = options.render;
  const bool isStated = options.statesSamples || render.targetError;
  // Of these there is an error to be estimated.
  const bool isOfColors =
      render.view == View::kColor || render.view == View::kSamples || render.view == View::kError;
  if (isStated || !isOfColors || scene.sphericalLights == 0) return std::nullopt;
  return kTargetError;
}

}  // namespace lavaray
